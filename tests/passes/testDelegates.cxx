// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chains of VTK's passes as delegates: the picture is the chain's own, bit for bit, and the layers
// are those of the plain renderer. And Relievo's passes as delegates of VTK's.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDepthOfFieldPass.h>
#include <vtkDepthPeelingPass.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkFloatArray.h>
#include <vtkFramebufferPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOverlayPass.h>
#include <vtkPixelBufferObject.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoLinearDepthPass.h>
#include <vtkRelievoPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkSobelGradientMagnitudePass.h>
#include <vtkTextureObject.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>

#include <functional>
#include <iostream>

namespace testDelegates
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "normal", "albedo", "actor", "cell" };

void Fill(vtkRenderer* renderer)
{
  const auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.7));
  ball->SetPosition(0., 0.7, 0.);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  const auto box = relievoTest::AddActor(renderer, relievoTest::MakeBox(3., 0.2, 3.));
  box->GetProperty()->SetColor(0.3, 0.5, 0.8);
  const auto glass = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.4));
  glass->SetPosition(0.8, 1., 1.2);
  glass->GetProperty()->SetOpacity(0.4);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetPosition(3., 5., 2.);
  light->SetFocalPoint(0., 0., 0.);
  light->SetConeAngle(60.);
  renderer->AddLight(light);
  renderer->SetBackground(0.1, 0.2, 0.3);
}

using PassPointer = vtkSmartPointer<vtkRenderPass>;

PassPointer Sequence(const std::vector<PassPointer>& passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (const PassPointer& pass : passes)
  {
    collection->AddItem(pass);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(collection);
  return PassPointer(sequence.Get());
}

template <typename Pass>
PassPointer Make()
{
  return vtkSmartPointer<Pass>::New();
}

PassPointer Camera(const PassPointer& inside)
{
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(inside);
  return PassPointer(camera.Get());
}

// Every step by hand.
PassPointer Steps(const PassPointer& translucent)
{
  return Camera(Sequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>(), translucent,
    Make<vtkVolumetricPass>(), Make<vtkOverlayPass>() }));
}

PassPointer Framebuffer()
{
  vtkNew<vtkFramebufferPass> pass;
  pass->SetDelegatePass(Make<vtkRenderStepsPass>());
  return PassPointer(pass.Get());
}

PassPointer Shadows()
{
  vtkNew<vtkShadowMapBakerPass> baker;
  baker->SetOpaqueSequence(Sequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>() }));
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetShadowMapBakerPass(baker);
  shadows->SetOpaqueSequence(Sequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>() }));
  return Camera(Sequence({ PassPointer(baker.Get()), PassPointer(shadows.Get()) }));
}

template <typename Peeling>
PassPointer Peeled()
{
  vtkNew<Peeling> peeling;
  peeling->SetTranslucentPass(Make<vtkTranslucentPass>());
  peeling->SetMaximumNumberOfPeels(4);
  peeling->SetOcclusionRatio(0.);
  return Steps(PassPointer(peeling.Get()));
}

template <typename Pass>
PassPointer Around()
{
  vtkNew<Pass> pass;
  pass->SetDelegatePass(Make<vtkRenderStepsPass>());
  return PassPointer(pass.Get());
}

struct Chain
{
  const char* Name;
  std::function<PassPointer()> Make;
};

const Chain Chains[] = {
  { "steps by hand", []() { return Steps(Make<vtkTranslucentPass>()); } },
  { "opaque only",
    []() {
      return Camera(Sequence({ Make<vtkLightsPass>(), Make<vtkOpaquePass>() }));
    } },
  { "translucent only",
    []() {
      return Camera(Sequence({ Make<vtkLightsPass>(), Make<vtkTranslucentPass>() }));
    } },
  { "framebuffer", Framebuffer },
  { "shadow maps", Shadows },
  { "depth peeling", Peeled<vtkDepthPeelingPass> },
  { "dual depth peeling", Peeled<vtkDualDepthPeelingPass> },
  { "depth of field", Around<vtkDepthOfFieldPass> },
  { "Sobel", Around<vtkSobelGradientMagnitudePass> },
};

void TestChain(const Chain& chain, bool part)
{
  const Stage stage(200, 140);
  Fill(stage.Renderer);
  if (part)
  {
    stage.Renderer->SetViewport(0.2, 0.1, 0.9, 0.8);
  }
  const relievoTest::GLCheck gl(stage.Window);
  const Layers plain(stage.Renderer, Names);
  const std::string what = std::string(chain.Name) + (part ? ", part of the window" : "");
  const PassPointer own = chain.Make();
  stage.Renderer->SetPass(own);
  // The first frame of some passes is not as the second.
  Picture(stage.Window);
  const auto before = Picture(stage.Window);
  const Layers alone(stage.Renderer, Names);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", attached");
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  for (int i = 0; i < 2; ++i)
  {
    relievoTest::SamePicture(before, Picture(stage.Window), what + ", with layers");
    vtkNew<vtkImageData> image;
    for (const std::string& name : Names)
    {
      RELIEVO_CHECK(frame->ReadLayer(name, image));
    }
    const Layers beside(image);
    for (const std::string& name : Names)
    {
      // Elsewhere in the window the rasteriser's last digits are others.
      const double slack = part && name == "normal" ? 2e-4 : 0.;
      const std::string layer = what + ": largest difference of " + name;
      RELIEVO_CHECK_AT_MOST(
        relievoTest::LargestDifference(plain, beside, name), slack, layer + " beside the picture");
      RELIEVO_CHECK_AT_MOST(
        relievoTest::LargestDifference(plain, alone, name), 0., layer + " without the picture");
    }
  }
  std::cout << what << ": " << (frame->GetLayersStage()->GetShared() ? "shared" : "own pass")
            << "\n";
  RELIEVO_CHECK(vtkRelievoPass::Detach(stage.Renderer) && stage.Renderer->GetPass() == own);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", detached");
  own->ReleaseGraphicsResources(stage.Window);
  stage.Renderer->SetPass(nullptr);
}

// The depth in world units, complete in a foreign float framebuffer.
void TestFloatFramebuffer(bool part, bool withDelegate)
{
  const Stage stage(160, 120);
  Fill(stage.Renderer);
  if (part)
  {
    stage.Renderer->SetViewport(0.25, 0.5, 1., 1.);
  }
  const relievoTest::GLCheck gl(stage.Window);
  const Layers layers(stage.Renderer, { "depth" });
  vtkNew<vtkRelievoLinearDepthPass> depth;
  depth->NormalizedOff();
  if (withDelegate)
  {
    depth->SetDelegatePass(Make<vtkRenderStepsPass>());
  }
  vtkNew<vtkFramebufferPass> framebuffer;
  framebuffer->SetColorFormat(vtkTextureObject::Float32);
  framebuffer->SetDelegatePass(depth);
  stage.Renderer->SetPass(framebuffer);
  stage.Window->Render();
  vtkTextureObject* texture = framebuffer->GetColorTexture();
  RELIEVO_CHECK(static_cast<int>(texture->GetWidth()) == layers.Width &&
    static_cast<int>(texture->GetHeight()) == layers.Height);
  vtkSmartPointer<vtkPixelBufferObject> buffer;
  buffer.TakeReference(texture->Download());
  std::vector<float> values(static_cast<std::size_t>(layers.Width) * layers.Height * 4);
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  vtkIdType none[2] = { 0, 0 };
  RELIEVO_CHECK(buffer->Download2D(VTK_FLOAT, values.data(), size, 4, none));
  double worst = 0.;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const double drawn = values[4 * (static_cast<std::size_t>(y) * layers.Width + x)];
      const double truth = layers.Value("depth", x, y);
      worst =
        std::max(worst, std::isinf(truth) ? std::abs(drawn - 1.) : std::abs(drawn / truth - 1.));
    }
  }
  const std::string what = std::string("float framebuffer") + (part ? ", part of the window" : "") +
    (withDelegate ? ", with a delegate" : "");
  RELIEVO_CHECK(layers.Covered() > 1000);
  // The depth is the rasteriser's, not refined; at edges it may be the neighbour's.
  RELIEVO_CHECK_AT_MOST(worst, 2e-3, what + ": depth in world units");
  framebuffer->ReleaseGraphicsResources(stage.Window);
  stage.Renderer->SetPass(nullptr);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testDelegates)
{
  relievoTest::Session session;
  for (const Chain& chain : Chains)
  {
    TestChain(chain, false);
    TestChain(chain, true);
  }
  for (const bool part : { false, true })
  {
    TestFloatFramebuffer(part, true);
    TestFloatFramebuffer(part, false);
  }
  return session.Result();
}
}
