// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stages in a frame: the frame determines their order; stages that cannot run give a reason and
// leave the picture unchanged; unrequested work is not done.
#include "Check.h"
#include "ColorStage.h"
#include "GLCheck.h"
#include "ImageCompare.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoStageRegistry.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cstring>
#include <string>

namespace testFrameStages
{
namespace
{
using relievoTest::ColorStage;
using relievoTest::IsSame;
using relievoTest::Picture;

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  Scene()
  {
    vtkNew<vtkSphereSource> ball;
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-2.0, -2.0, -0.6);
    floor->SetPoint1(2.0, -2.0, -0.6);
    floor->SetPoint2(-2.0, 2.0, -0.6);
    for (vtkAlgorithm* source :
      { static_cast<vtkAlgorithm*>(ball), static_cast<vtkAlgorithm*>(floor) })
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      this->Renderer->AddActor(actor);
    }
    vtkNew<vtkLight> sun;
    sun->SetPosition(1.0, 0.5, 2.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(sun);
    this->Window = relievoTest::MakeWindow(100, 80, this->Renderer);
    this->Renderer->ResetCamera();
  }
};

vtkSmartPointer<ColorStage> MakeStage(const char* name, double factor, double shift)
{
  auto stage = vtkSmartPointer<ColorStage>::New();
  stage->Name = name;
  stage->Factor = factor;
  stage->Shift = shift;
  return stage;
}

// Times 2 and then plus a tenth is not plus a tenth and then times 2: names decide, not additions.
void TestOrder()
{
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const int order : { 0, 1 })
  {
    Scene scene;
    vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
    const auto first = MakeStage("a_factor", 2.0, 0.0);
    const auto second = MakeStage("b_shift", 1.0, 0.1);
    frame->AddStage(order ? second : first);
    frame->AddStage(order ? first : second);
    pictures[order] = Picture(scene.Window);
    RELIEVO_CHECK(first->Executed == 1 && second->Executed == 1);
  }
  RELIEVO_CHECK_THAT(IsSame(pictures[0], pictures[1]), "the order of additions is seen");
  Scene scene;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->AddStage(MakeStage("b_factor", 2.0, 0.0));
  frame->AddStage(MakeStage("a_shift", 1.0, 0.1));
  RELIEVO_CHECK_THAT(!IsSame(pictures[0], Picture(scene.Window)), "the order is not seen at all");
}

// A stage that reads a resource without a writer.
class Hungry : public ColorStage
{
public:
  static Hungry* New() { VTK_STANDARD_NEW_BODY(Hungry); }
  vtkTypeMacro(Hungry, ColorStage);

protected:
  void Declare(const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const override
  {
    declaration.Reads.push_back(vtkRelievoResources::Depth);
  }
};

void TestMissing()
{
  Scene scene;
  const auto plain = Picture(scene.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetStage("gbuffer")->EnabledOff();
  vtkNew<Hungry> stage;
  frame->AddStage(stage);
  {
    relievoTest::ExpectMessage expect("The stage shift does not run: it reads 'depth'");
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    RELIEVO_CHECK(stage->GetReasonCode() == "refused" && stage->Executed == 0);
    RELIEVO_CHECK(stage->GetReason().find("the stage gbuffer would write") != std::string::npos);
    scene.Window->Render();
    RELIEVO_CHECK_THAT(expect.Count() == 1, "said in every frame");
  }
  frame->GetStage("gbuffer")->EnabledOn();
  scene.Window->Render();
  RELIEVO_CHECK(stage->Executed == 1);
}

// Only layers: no map for invisible shadows, no stage on the colour, no pixel of the window.
void TestLayersOnly()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  vtkNew<ColorStage> stage;
  stage->Factor = 0.5;
  frame->AddStage(stage);
  const auto before = Picture(scene.Window);
  RELIEVO_CHECK(stage->Executed == 1 && frame->GetShadowStage()->GetNumberOfMapsDrawn() == 1);
  frame->RequestLayer("depth");
  frame->SetDisplayLayer("depth");
  frame->LayersOnlyOn();
  scene.Window->Render();
  RELIEVO_CHECK(stage->Executed == 1);
  RELIEVO_CHECK(stage->GetReasonCode() == "not_asked");
  RELIEVO_CHECK(frame->GetShadowStage()->GetReasonCode() == "not_asked");
  RELIEVO_CHECK(frame->GetShadowStage()->GetBytesHeld() == 0);
  RELIEVO_CHECK(frame->GetStage("display")->GetReasonCode() == "not_asked");
  RELIEVO_CHECK(frame->GetStage("gbuffer")->GetReasonCode() == "ran");
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayer("depth", image));
  // A layer that is shown hides the colour: nothing works on it, no light is looked up for it.
  frame->LayersOnlyOff();
  scene.Window->Render();
  RELIEVO_CHECK(stage->Executed == 1 && stage->GetReasonCode() == "hidden");
  RELIEVO_CHECK(frame->GetShadowStage()->GetReasonCode() == "not_asked");
  frame->SetDisplayLayer(nullptr);
  frame->ReleaseLayers();
  RELIEVO_CHECK(IsSame(before, Picture(scene.Window)));
  gl.Poll("layers only");
}

ColorStage* NewRegistered()
{
  ColorStage* stage = ColorStage::New();
  stage->Name = "registered";
  return stage;
}

// A stage of another library: frames have it by name, off, and an own one takes its place.
void TestRegistry()
{
  RELIEVO_CHECK(vtkRelievoStageRegistry::Add([]() -> vtkRelievoStage* { return NewRegistered(); }));
  Scene scene;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoStage* stage = frame->GetStage("registered");
  if (!RELIEVO_CHECK(stage))
  {
    return;
  }
  const int count = frame->GetNumberOfStages();
  RELIEVO_CHECK(!stage->GetEnabled());
  const auto plain = Picture(scene.Window);
  RELIEVO_CHECK(stage->GetReasonCode() == "off");
  stage->EnabledOn();
  RELIEVO_CHECK(stage->SetParameter("factor", "0.5"));
  RELIEVO_CHECK(!IsSame(plain, Picture(scene.Window)));
  RELIEVO_CHECK(
    frame->GetFrameReport().find("\"name\": \"registered\", \"ran\": true") != std::string::npos);
  const auto own = MakeStage("registered", 1.5, 0.0);
  frame->AddStage(own);
  RELIEVO_CHECK(frame->GetNumberOfStages() == count && frame->GetStage("registered") == own);
  scene.Window->Render();
  RELIEVO_CHECK(own->Executed == 1);
}
}

RELIEVO_TEST_CASE(testFrameStages)
{
  relievoTest::Session session;
  TestOrder();
  TestMissing();
  TestLayersOnly();
  TestRegistry();
  return session.Result();
}
}
