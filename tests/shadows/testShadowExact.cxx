// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows: the real meshes against Embree, light through panes against the product of their
// transmittances, and difficult cases for a hierarchy of triangles.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "MadeMeshes.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderPass.h>
#include <vtkRenderState.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace testShadowExact
{
namespace
{
using relievoTest::Layers;
using relievoTest::SceneLight;
using relievoTest::ShadowStage;

constexpr double Limit = 2e-5;

// Draws through an actor of its own, as ParaView's actors of surfaces do.
class DeviceActor : public vtkActor
{
public:
  static DeviceActor* New();
  vtkTypeMacro(DeviceActor, vtkActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    this->Device->SetProperty(this->GetProperty());
    this->Device->SetPropertyKeys(this->GetPropertyKeys());
    this->Device->SetMapper(mapper);
    this->Device->Render(renderer, mapper);
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Device->ReleaseGraphicsResources(window);
    this->Superclass::ReleaseGraphicsResources(window);
  }

private:
  vtkNew<vtkActor> Device;
};
vtkStandardNewMacro(DeviceActor);

// Draws like the renderer's own steps.
class StepsPass : public vtkRenderPass
{
public:
  static StepsPass* New();
  vtkTypeMacro(StepsPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->UpdateCamera(state->GetRenderer());
    this->ClearLights(state->GetRenderer());
    this->UpdateLightGeometry(state->GetRenderer());
    this->UpdateLights(state->GetRenderer());
    this->UpdateGeometry(state->GetRenderer());
  }
};
vtkStandardNewMacro(StepsPass);

const float* Visibility(vtkImageData* image)
{
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
}

// With the edges of cells drawn, where the same cell is seen: VTK before 9.3 draws triangles with
// edges wider than they are, and so others at their rims.
void TestEdges(
  const relievoTest::ReferenceScene& scene, relievoTest::ShadowTruth truth, const std::string& what)
{
  const Layers plain(scene.Renderer, { "actor", "cell" });
  for (const auto& actor : { scene.MeshActor, scene.GroundActor })
  {
    actor->GetProperty()->EdgeVisibilityOn();
  }
  const Layers edges(scene.Renderer, { "shadow_0", "actor", "cell" });
  for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
  {
    const int x = static_cast<int>(i) % truth.Width, y = static_cast<int>(i) / truth.Width;
    if (plain.Id("cell", x, y) != edges.Id("cell", x, y) ||
      plain.Id("actor", x, y) != edges.Id("actor", x, y))
    {
      truth.Verdicts[i] = relievoTest::ShadowTruth::Unjudged;
    }
  }
  const auto errors = relievoTest::CompareShadow(truth, Visibility(edges.Image));
  std::cout << what << ", edges: " << errors.ToString() << std::endl;
  RELIEVO_CHECK_THAT(errors.Compared > truth.Width * truth.Height / 12, what + ": compared");
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), Limit, what + ": share of wrong with edges");
  for (const auto& actor : { scene.MeshActor, scene.GroundActor })
  {
    actor->GetProperty()->EdgeVisibilityOff();
  }
}

void TestMesh(const std::string& mesh, SceneLight kind, int width, int height)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(width, height, scene.Renderer);
  relievoTest::GLCheck gl(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetShadowStage()->SetMethodToExact();
  const auto truth = scene.MakeTruth();
  window->Render();
  const auto shadow =
    relievoTest::TraceShadow(*truth, truth->Trace(relievoTest::View(scene.Renderer)), scene.Light);
  const Layers phong(scene.Renderer, { "shadow_0" });
  const auto errors = relievoTest::CompareShadow(shadow, Visibility(phong.Image));
  const std::string what = mesh + ", " + std::to_string(width) + " x " + std::to_string(height);
  std::cout << what << ": " << errors.ToString() << std::endl;
  RELIEVO_CHECK_THAT(errors.Compared > width * height / 9 && errors.Dark > width * height / 200,
    what + ": what is compared");
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), Limit, what + ": share of wrong verdicts");
  scene.MeshActor->GetProperty()->SetInterpolationToPBR();
  scene.GroundActor->GetProperty()->SetInterpolationToPBR();
  const Layers pbr(scene.Renderer, { "shadow_0" });
  RELIEVO_CHECK_AT_MOST(
    relievoTest::CountDifferent(phong, pbr, "shadow_0"), 0, what + ": pixels unlike with PBR");
  TestEdges(scene, shadow, what);
  RELIEVO_CHECK_THAT(frame->GetShadowStage()->GetNumberOfMaps() == 0, what + ": maps");
  // At most 64 bytes for each of the mesh's triangles, plus the ground's; 16 a pixel, and 4 for
  // each tile of 8 x 8.
  const auto bytes = static_cast<double>(frame->GetShadowStage()->GetBytesHeld());
  RELIEVO_CHECK_AT_MOST(bytes,
    64. * static_cast<double>(truth->NumberOfTriangles()) + 4096. +
      (16. + 4. / 64.) * (width + 7) * (height + 7),
    what + ": bytes held");
  gl.Poll(mesh);
  vtkRelievoPass::Detach(scene.Renderer);
}

// Triangles smaller than pixels: the judged surface is the one that OpenGL draws there.
void TestSmall(SceneLight kind)
{
  const auto scene = relievoTest::MakeReferenceScene("bunny", kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(96, 72, scene.Renderer);
  vtkRelievoPass::Attach(scene.Renderer)->GetShadowStage()->SetMethodToExact();
  const auto truth = scene.MakeTruth();
  window->Render();
  const auto seen = truth->Trace(relievoTest::View(scene.Renderer));
  const auto shadow =
    relievoTest::WithoutEdges(relievoTest::TraceShadow(*truth, seen, scene.Light), seen);
  const Layers layers(scene.Renderer, { "shadow_0" });
  const auto errors = relievoTest::CompareShadow(shadow, Visibility(layers.Image));
  std::cout << "small: " << errors.ToString() << std::endl;
  RELIEVO_CHECK_THAT(errors.Compared > 3500 && errors.Dark > 100, "small: what is compared");
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), 0., "small: share of wrong verdicts");
  vtkRelievoPass::Detach(scene.Renderer);
}

void TestHorizon()
{
  ShadowStage stage(400, 300);
  stage.AddPolesToHorizon();
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, Limit, "horizon");
}

// Two panes over the ground: each point receives the product over the panes hit by its rays, by the
// panes' extent.
void TestPanes()
{
  ShadowStage stage;
  stage.AddGround();
  const double opacity[2] = { 0.3, 0.5 };
  for (int i = 0; i < 2; ++i)
  {
    const double x = -1.5 + 0.8 * i;
    const double y = 4. + i; // out of the picture
    const auto mesh = relievoTest::MakePolygons(
      { { x, y, -1. }, { x + 1.6, y, -1. }, { x + 1.6, y, 1. }, { x, y, 1. } });
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    const auto pane = relievoTest::AddActor(stage.Renderer, mesh);
    pane->GetProperty()->SetOpacity(opacity[i]);
    stage.GetShadows()->SetPropCasts(pane, vtkRelievoShadowStage::CASTS_ALWAYS);
  }
  stage.AddSun(0., 5., 0.);
  stage.GetShadows()->SetMethodToExact();
  const auto image = relievoTest::CaptureShadow(stage, 0);
  relievoTest::EmbreeScene ground;
  const auto mesh = relievoTest::MakePolygons(
    { { -3., 0., 3. }, { 3., 0., 3. }, { 3., 0., -3. }, { -3., 0., -3. } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  ground.AddActor(mesh);
  const auto view = ground.Trace(relievoTest::View(stage.Renderer));
  long long seen[4] = { 0, 0, 0, 0 };
  long long mismatches = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    const glm::dvec3& p = view.Pixels[i].Position;
    if (!view.Pixels[i].Hit || std::abs(p.y) > 1e-6)
    {
      continue;
    }
    double passes = 1.;
    int which = 0;
    bool tie = false;
    for (int k = 0; k < 2; ++k)
    {
      const double x = -1.5 + 0.8 * k;
      tie = tie || std::abs(p.x - x) < 1e-5 || std::abs(p.x - x - 1.6) < 1e-5 ||
        std::abs(std::abs(p.z) - 1.) < 1e-5;
      if (p.x > x && p.x < x + 1.6 && std::abs(p.z) < 1.)
      {
        passes *= 1. - opacity[k];
        which += 1 << k;
      }
    }
    ++seen[which];
    mismatches += !tie && std::abs(Visibility(image)[i] - passes) > 0.51 / 255. ? 1 : 0; // 8 bits
  }
  RELIEVO_CHECK_THAT(seen[1] > 300 && seen[2] > 300 && seen[3] > 300, "panes: too little is seen");
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "panes: pixels that pass another share");
}

// Balls of float points away from the origin, which VTK's shader places by float matrices: their
// sides that face the light are lit.
void TestFarFloats()
{
  for (const double away : { 0., 100., 300., 1000., 3000. })
  {
    ShadowStage stage;
    vtkNew<vtkSphereSource> ball; // its points are floats
    ball->SetCenter(away, 0.37 * away, 0.11 * away);
    ball->SetRadius(0.5);
    ball->SetThetaResolution(64);
    ball->SetPhiResolution(64);
    ball->Update();
    relievoTest::AddActor(stage.Renderer, ball->GetOutput());
    const double* center = ball->GetCenter();
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetFocalPoint(center);
    camera->SetPosition(center[0] + 0.4, center[1] + 0.6, center[2] + 2.);
    camera->SetClippingRange(0.5, 10.);
    const auto light = stage.AddSun(0., 0., 0.);
    light->SetFocalPoint(0., 0., 0.);
    light->SetPosition(3., 5., 2.);
    stage.GetShadows()->SetMethodToExact();
    const auto truth = relievoTest::TraceStage(stage, 0);
    const auto image = relievoTest::CaptureShadow(stage, 0);
    long long dark = 0;
    long long lit = 0;
    for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
    {
      lit += truth.Verdicts[i] == relievoTest::ShadowTruth::Lit ? 1 : 0;
      dark += truth.Verdicts[i] == relievoTest::ShadowTruth::Lit && Visibility(image)[i] < 1.f;
    }
    const std::string what = "ball " + std::to_string(away) + " from the origin";
    RELIEVO_CHECK_THAT(lit > 5000, what + ": pixels that face the light");
    RELIEVO_CHECK_AT_MOST(dark, 0, what + ": of these, dark");
  }
}

// Slivers, triangles without area or place, surfaces twice in one place; then all moves and hides.
void TestTroubles()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddGround();
  stage.AddThings();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto mesh =
    relievoTest::MakePolygons({ { -1., 1.5, 0. }, { 1., 1.5, 0. }, { 1., 1.5 + 1e-7, 1e-5 },
      { 0., 1.5, 0. }, { none, 0., 0. }, { -2., 1.2, 1. }, { -1., 1.2, 1. }, { -1., 1.2, 2. } });
  for (const auto& cell :
    { std::array<vtkIdType, 3>{ 0, 1, 2 }, { 0, 1, 3 }, { 0, 3, 3 }, { 0, 1, 4 }, { 5, 6, 7 } })
  {
    mesh->GetPolys()->InsertNextCell(3, cell.data());
  }
  relievoTest::AddActor(stage.Renderer, mesh);
  const auto box = stage.AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, 4e-5, "troubles");
  auto* data = vtkPolyDataMapper::SafeDownCast(box->GetMapper())->GetInput();
  for (int step = 0; step < 3; ++step)
  {
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      data->GetPoints()->SetPoint(i, p[0] - 0.4, p[1] + 0.1 * (i % 2), p[2]);
    }
    data->GetPoints()->Modified();
    relievoTest::CheckShadow(stage, 0, 4e-5, "moved points, step " + std::to_string(step));
  }
  box->SetPosition(0.3, 0.2, -0.4);
  relievoTest::CheckShadow(stage, 0, 4e-5, "moved actor");
  box->VisibilityOff();
  relievoTest::CheckShadow(stage, 0, 4e-5, "hidden");
}

// Fins whose tops are long and a pixel wide or less: OpenGL's grid of 1/256 pixel tilts them.
void TestSlivers()
{
  ShadowStage stage(500, 400);
  stage.AddGround();
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeFins());
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(2.5, 3., 6.);
  camera->SetFocalPoint(0., 0.5, 0.);
  stage.Renderer->ResetCameraClippingRange();
  stage.AddSun(3., 5., 2.);
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, Limit, "slivers");
}

// Mountains of folds in all directions: a pixel's place lies behind the plane beside it, where the
// fold is concave and the pixel's centre on it.
void TestCreases()
{
  ShadowStage stage(600, 450);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeFolds());
  stage.AddSun(3., 2., 2.);
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, Limit, "creases");
}

// Casters without triangles are drawn into a map, and block the light that rays let pass.
void TestOthers()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ 0.2, 0.8, -0.1 }, { 1.2, 1.6, 0.5 });
  stage.AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  const auto both = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfMaps() == 1);
  stage.GetShadows()->SetMethodToMap();
  const auto map = relievoTest::CaptureShadow(stage, 0);
  long long unlike = 0;
  long long dark = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    dark += Visibility(map)[i] < 0.5f;
    unlike += std::abs(Visibility(map)[i] - Visibility(both)[i]) > 0.6f;
  }
  RELIEVO_CHECK_THAT(dark > 1000, "others: too little is dark");
  RELIEVO_CHECK_AT_MOST(unlike, dark / 100, "others: pixels unlike map's");
  // Nothing at all casts.
  ShadowStage empty;
  empty.AddSun(-3., 4., -2.);
  empty.GetShadows()->SetMethodToExact();
  empty.GetFrame()->ShadowsOn();
  empty.Window->Render();
  RELIEVO_CHECK(empty.GetShadows()->GetNumberOfMaps() == 0);
}

// Notes whether the program of a mapper that draws traces rays.
void NoteProgram(vtkObject*, unsigned long, void* traced, void* program)
{
  const std::string source =
    static_cast<vtkShaderProgram*>(program)->GetFragmentShader()->GetSource();
  static_cast<std::vector<bool>*>(traced)->push_back(
    source.find("relievoTreeWalk(") != std::string::npos);
}

// Behind a pass that draws like the renderer's own steps no fragment traces rays, also if actors
// draw through others and with depth offsets, as in ParaView. The picture is the one of fragments
// that trace them.
void TestOwnSteps()
{
  vtkRelievoShadowStage::AddPlainActorClass("DeviceActor");
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const bool own : { false, true })
  {
    ShadowStage stage;
    std::vector<bool> traced;
    vtkNew<vtkCallbackCommand> note;
    note->SetCallback(NoteProgram);
    note->SetClientData(&traced);
    const std::vector<vtkSmartPointer<vtkActor>> actors = { stage.AddGround(),
      stage.AddBox({ 0.2, 0.8, -0.1 }, { 1.2, 1.6, 0.5 }),
      stage.AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 }) };
    for (vtkActor* actor : actors)
    {
      vtkNew<DeviceActor> device;
      device->SetMapper(actor->GetMapper());
      actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, note);
      stage.Renderer->RemoveActor(actor);
      stage.Renderer->AddActor(device);
    }
    stage.AddSun(-3., 4., -2.);
    stage.GetShadows()->SetMethodToExact();
    stage.GetFrame()->SetDelegatePass(vtkSmartPointer<StepsPass>::New());
    stage.GetFrame()->SetDelegateDrawsOwnSteps(own);
    stage.GetFrame()->ShadowsOn();
    stage.Window->Render(); // builds the mappers' buffers
    traced.clear();
    pictures[own] = relievoTest::Picture(stage.Window);
    RELIEVO_CHECK_THAT(traced == std::vector<bool>(actors.size(), !own),
      own ? "own steps: fragments trace rays" : "a pass: fragments trace no rays");
  }
  relievoTest::SamePicture(pictures[0], pictures[1], "own steps");
  vtkMapper::SetResolveCoincidentTopologyToOff();
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowExact)
{
  relievoTest::Session session;
  const std::string which = argc > 1 ? argv[1] : "";
  if (which == "few")
  {
    TestHorizon();
    TestPanes();
    TestTroubles();
    return session.Result();
  }
  if (which == "meshes") // other lights and shapes, which all versions of VTK draw alike
  {
    TestMesh("bunny", SceneLight::Spot, 400, 225);
    TestMesh("motorBike", SceneLight::Sun, 300, 300);
    TestMesh("buildings", SceneLight::Point, 200, 600);
    return session.Result();
  }
  TestMesh("bunny", SceneLight::Sun, 300, 300);
  TestSmall(SceneLight::Sun);
  TestSmall(SceneLight::Spot);
  TestSmall(SceneLight::Point);
  TestHorizon();
  TestPanes();
  TestFarFloats();
  TestTroubles();
  TestSlivers();
  TestCreases();
  TestOthers();
  TestOwnSteps();
  return session.Result();
}
}
