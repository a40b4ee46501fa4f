// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that share one vtkInformation of property keys: actors that were given the same, copies of
// an actor, parts of assemblies; and keys that are copied while a pass is in them. Layers and
// shadows are those of the same scene without sharing, and no pass stays in any keys.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropAssembly.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <functional>

namespace testSharedKeys
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;

const std::vector<std::string> Names = { "depth", "normal", "albedo", "actor" };

vtkSmartPointer<vtkActor> AddBall(vtkRenderer* renderer, double x)
{
  auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.5));
  ball->SetPosition(x, 0.6, 0.);
  ball->GetProperty()->SetColor(0.9, 0.5 + 0.3 * x, 0.2);
  return ball;
}

void AddRest(vtkRenderer* renderer)
{
  relievoTest::AddActor(renderer, relievoTest::MakeBox(4., 0.1, 4.));
  vtkNew<vtkLight> sun;
  sun->SetPosition(3., 5., 2.);
  sun->SetFocalPoint(0., 0., 0.);
  sun->PositionalOff();
  renderer->RemoveAllLights();
  renderer->AddLight(sun);
}

int CountPasses(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
}

struct Shown
{
  vtkSmartPointer<vtkImageData> Plain;
  vtkSmartPointer<vtkImageData> Shadows;
  std::unique_ptr<Layers> Beside;
  std::unique_ptr<Layers> Alone;
};

Shown Show(vtkRenderer* renderer, vtkRenderWindow* window)
{
  Shown shown;
  shown.Plain = Picture(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  frame->ShadowsOn();
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  for (int i = 0; i < 2; ++i)
  {
    shown.Shadows = Picture(window);
  }
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayers(Names, image));
  shown.Beside = std::make_unique<Layers>(image);
  vtkRelievoPass::Detach(renderer);
  shown.Alone = std::make_unique<Layers>(renderer, Names);
  RELIEVO_CHECK_AT_MOST(
    relievoTest::CountDifferent(*shown.Beside, *shown.Alone, "depth"), 0, "depth both ways");
  return shown;
}

struct Case
{
  const char* Name;
  // Adds two balls; `shared` by keys.
  std::vector<vtkSmartPointer<vtkProp>> (*Add)(vtkRenderer*, vtkRenderWindow*, bool shared);
};

std::vector<vtkSmartPointer<vtkProp>> AddGiven(vtkRenderer* renderer, vtkRenderWindow*, bool shared)
{
  auto a = AddBall(renderer, -0.6);
  auto b = AddBall(renderer, 0.6);
  AddRest(renderer);
  if (shared)
  {
    vtkNew<vtkInformation> keys;
    a->SetPropertyKeys(keys);
    b->SetPropertyKeys(keys);
  }
  return { a, b };
}

// vtkActor::ShallowCopy copies the keys' pointer: after a frame with layers these are there.
std::vector<vtkSmartPointer<vtkProp>> AddCopied(
  vtkRenderer* renderer, vtkRenderWindow* window, bool shared)
{
  auto a = AddBall(renderer, -0.6);
  vtkSmartPointer<vtkActor> b = AddBall(renderer, 0.6);
  AddRest(renderer);
  if (shared)
  {
    const Shown before = Show(renderer, window);
    vtkNew<vtkActor> copy;
    copy->ShallowCopy(a);
    RELIEVO_CHECK(copy->GetPropertyKeys() == a->GetPropertyKeys());
    copy->SetPosition(b->GetPosition());
    copy->SetMapper(b->GetMapper());
    copy->SetProperty(b->GetProperty());
    // In the place of the one that it stands for.
    renderer->RemoveActor(b);
    vtkProp* ground = renderer->GetViewProps()->GetLastProp();
    vtkSmartPointer<vtkProp> kept = ground;
    renderer->RemoveViewProp(ground);
    renderer->AddActor(copy);
    renderer->AddViewProp(kept);
    b = copy;
  }
  return { a, b };
}

// The parts are drawn by the assembly, and one of them on its own as well.
template <typename Assembly>
std::vector<vtkSmartPointer<vtkProp>> AddParts(vtkRenderer* renderer, vtkRenderWindow*, bool shared)
{
  auto a = AddBall(renderer, -0.6);
  auto b = AddBall(renderer, 0.6);
  AddRest(renderer);
  std::vector<vtkSmartPointer<vtkProp>> props = { a, b };
  if (shared)
  {
    vtkNew<Assembly> assembly;
    assembly->AddPart(b);
    renderer->AddViewProp(assembly);
    props.emplace_back(assembly);
  }
  return props;
}

const Case Cases[] = {
  { "keys given to two", AddGiven },
  { "a copied actor", AddCopied },
  { "a part of an assembly", AddParts<vtkAssembly> },
  { "a part of a prop assembly", AddParts<vtkPropAssembly> },
};

void Test(const Case& c)
{
  const std::string what = c.Name;
  const Stage apart(200, 140);
  c.Add(apart.Renderer, apart.Window, false);
  const Shown expected = Show(apart.Renderer, apart.Window);
  const Stage stage(200, 140);
  const relievoTest::GLCheck gl(stage.Window);
  const auto props = c.Add(stage.Renderer, stage.Window, true);
  for (int i = 0; i < 2; ++i)
  {
    const Shown shown = Show(stage.Renderer, stage.Window);
    relievoTest::SamePicture(expected.Plain, shown.Plain, what + ", without Relievo");
    relievoTest::SamePicture(expected.Shadows, shown.Shadows, what + ", with shadows");
    for (const std::string& name : Names)
    {
      // A ball that is drawn twice is one actor of the two.
      RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(*expected.Beside, *shown.Beside, name), 0,
        what + ": pixels of " + name);
    }
    RELIEVO_CHECK(shown.Beside->CountId("actor", 0) > 500);
    RELIEVO_CHECK(shown.Beside->CountId("actor", 1) > 500);
    for (const auto& prop : props)
    {
      RELIEVO_CHECK(CountPasses(prop) == 0);
    }
  }
}

// Whether a prop receives shadows is its own choice, also where the keys are shared.
void TestReceiving()
{
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const bool shared : { false, true })
  {
    const Stage stage(200, 140);
    const auto props = AddGiven(stage.Renderer, stage.Window, shared);
    auto ground = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetLastProp());
    if (shared)
    {
      ground->SetPropertyKeys(props[0]->GetPropertyKeys());
    }
    vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
    frame->ShadowsOn();
    frame->GetShadowStage()->SetPropReceives(props[0], false);
    pictures[shared ? 1 : 0] = Picture(stage.Window);
  }
  relievoTest::SamePicture(pictures[0], pictures[1], "one of those that share receives none");
}

// Draws by another actor, with a copy of its keys, as they are while it is drawn.
class CopyingActor : public vtkActor
{
public:
  static CopyingActor* New();
  vtkTypeMacro(CopyingActor, vtkActor);

  vtkNew<vtkActor> Device;

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    vtkNew<vtkInformation> keys;
    if (this->GetPropertyKeys())
    {
      keys->Copy(this->GetPropertyKeys());
    }
    this->Device->SetPropertyKeys(keys);
    this->Device->SetProperty(this->GetProperty());
    this->Device->SetUserMatrix(this->GetMatrix());
    this->Device->SetMapper(mapper);
    this->Device->Render(renderer, mapper);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Device->ReleaseGraphicsResources(window);
    this->Superclass::ReleaseGraphicsResources(window);
  }
};
vtkStandardNewMacro(CopyingActor);

// Keys that were copied during a frame hold its passes for good: these do nothing outside of it.
void TestStray()
{
  const Stage stage(200, 140);
  AddRest(stage.Renderer);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(relievoTest::MakeBall(0.5));
  vtkNew<CopyingActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0., 0.6, 0.);
  actor->GetProperty()->SetColor(0.9, 0.4, 0.1);
  stage.Renderer->AddActor(actor);
  const relievoTest::GLCheck gl(stage.Window);
  const auto plain = Picture(stage.Window);
  const Layers before(stage.Renderer, Names);
  vtkSmartPointer<vtkImageData> shadows;
  for (int i = 0; i < 2; ++i)
  {
    vtkSmartPointer<vtkRelievoPass> frame = vtkRelievoPass::Attach(stage.Renderer);
    frame->ShadowsOn();
    frame->RequestLayer("depth");
    frame->RequestLayer("normal");
    const auto now = Picture(stage.Window);
    RELIEVO_CHECK(CountPasses(actor->Device) > 0);
    shadows = shadows ? shadows : now;
    relievoTest::SamePicture(shadows, now, "copied keys, with shadows again");
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayers({ "depth", "normal" }, image));
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(before, Layers(image), "normal"), 0,
      "copied keys: pixels of normal");
    vtkRelievoPass::Detach(stage.Renderer);
    // By the actor of the copied keys itself, without copying them again.
    stage.Renderer->RemoveActor(actor);
    stage.Renderer->AddActor(actor->Device);
    relievoTest::SamePicture(plain, Picture(stage.Window), "keys with a pass of another frame");
    const Layers after(stage.Renderer, Names);
    for (const char* name : { "depth", "normal", "albedo" })
    {
      RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(before, after, name), 0,
        std::string("keys with a pass of another frame: pixels of ") + name);
    }
    stage.Renderer->RemoveActor(actor->Device);
    stage.Renderer->AddActor(actor);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSharedKeys)
{
  relievoTest::Session session;
  for (const Case& c : Cases)
  {
    Test(c);
  }
  TestReceiving();
  TestStray();
  return session.Result();
}
}
