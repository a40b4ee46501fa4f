// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cubes that the vertex shader sizes and moves, against the same from vtkRelievoVoxelCubes, which
// computes them in double: depth, normals, colors and shadows, as settings change; bounds.
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
#include <vtkCellData.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoVoxelCubes.h>
#include <vtkRelievoVoxelCubesActor.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <string>

namespace testVoxelCubesActor
{
namespace
{
using namespace relievoTest;

constexpr int Cells = 12;

vtkSmartPointer<vtkImageData> MakeMask()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  image->SetSpacing(0.25, 0.2, 0.3);
  image->SetOrigin(-1.5, -1.2, -1.8);
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("mask");
  for (int cell = 0; cell < Cells * Cells * Cells; ++cell)
  {
    const double x = cell % Cells - 5.5;
    const double y = cell / Cells % Cells - 5.5;
    const double z = cell / Cells / Cells - 5.5;
    mask->InsertNextValue(x * x + y * y + z * z < 12. ? 1 : 0);
  }
  image->GetCellData()->AddArray(mask);
  return image;
}

struct Settings
{
  double Transition = 0.5;
  double RestSize = 0.05;
  double Growth = 1.;
  double Repeller[3] = { 0.4, -0.7, 0.8 };
  double RepellerRadius = 0.;
};

// The cubes over a floor, in light from above, by the filter or by the shader.
struct Scene
{
  relievoTest::Stage Stage{ 160, 120 };
  vtkNew<vtkRelievoVoxelCubes> Filter;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkRelievoVoxelCubesActor> Instanced;
  GLCheck Watch{ this->Stage.Window };

  explicit Scene(bool instanced)
  {
    this->Filter->SetInputData(MakeMask());
    this->Filter->SetInputData(1, this->MakeColors());
    this->Filter->SetInstanced(instanced);
    this->Filter->WholeGridOn();
    this->Filter->SetTransition(0.5);
    if (instanced)
    {
      this->Instanced = vtkSmartPointer<vtkRelievoVoxelCubesActor>::New();
      this->Instanced->SetInputConnection(this->Filter->GetOutputPort());
      this->Instanced->SetCellSize(0.25, 0.2, 0.3);
      this->Actor = this->Instanced;
    }
    else
    {
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputConnection(this->Filter->GetOutputPort());
      mapper->SetSourceData(MakeBox(1., 1., 1.));
      mapper->SetScaleModeToScaleByVectorComponents();
      mapper->SetScaleArray("scale");
      mapper->OrientOff();
      this->Actor = vtkSmartPointer<vtkActor>::New();
      this->Actor->SetMapper(mapper);
    }
    vtkRenderer* renderer = this->Stage.Renderer;
    renderer->AddActor(this->Actor);
    AddActor(renderer, Moved(MakeBox(8., 8., 0.1), 0., 0., -2.2));
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(2., 1., 6.);
    renderer->AddLight(sun);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(5., -7., 6.);
    camera->SetFocalPoint(0., 0., -0.5);
    camera->SetViewUp(0., 0., 1.);
    camera->SetClippingRange(2., 25.);
    vtkRelievoPass::Attach(renderer)->ShadowsOn();
  }
  ~Scene() { vtkRelievoPass::Detach(this->Stage.Renderer); }

  void Set(const Settings& settings)
  {
    const auto apply = [&settings](auto* to) {
      to->SetTransition(settings.Transition);
      to->SetRestSize(settings.RestSize);
      to->SetGrowth(settings.Growth);
      to->SetRepeller(settings.Repeller);
      to->SetRepellerRadius(settings.RepellerRadius);
    };
    if (this->Instanced)
    {
      apply(this->Instanced.Get());
    }
    else
    {
      apply(this->Filter.Get());
    }
  }

private:
  static vtkSmartPointer<vtkPolyData> MakeColors()
  {
    vtkSmartPointer<vtkPolyData> ball = relievoTest::MakeBall(1.);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("color");
    colors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
    {
      colors->InsertNextTuple3(100. + i % 7 * 20., 200. - i % 5 * 30., 90. + i % 3 * 60.);
    }
    ball->GetPointData()->SetScalars(colors);
    return ball;
  }
};

// Edges may fall on other pixels, as places are computed in float here and in double there.
void Compare(Scene& truth, Scene& scene, const std::string& what)
{
  const Layers a(truth.Stage.Renderer, { "depth", "normal" });
  const Layers b(scene.Stage.Renderer, { "depth", "normal" });
  double different = 0.;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      const double apart = std::abs(a.Value("depth", x, y) - b.Value("depth", x, y));
      const double turned = glm::distance(a.Vector("normal", x, y), b.Vector("normal", x, y));
      const bool none = std::isinf(a.Value("depth", x, y)) && std::isinf(b.Value("depth", x, y));
      different += none || (apart < 1e-4 && turned < 0.01) ? 0. : 1.;
    }
  }
  const double pixels = a.Width * a.Height;
  RELIEVO_CHECK_AT_MOST(100. * different / pixels, 0.3, what + ", layers, % of pixels");
  // Also the shadows on the floor.
  const auto first = Picture(truth.Stage.Window);
  const auto second = Picture(scene.Stage.Window);
  auto* one = static_cast<unsigned char*>(first->GetScalarPointer());
  auto* two = static_cast<unsigned char*>(second->GetScalarPointer());
  different = 0.;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    different += std::abs(one[3 * i] - two[3 * i]) > 8 ? 1. : 0.;
  }
  RELIEVO_CHECK_AT_MOST(100. * different / pixels, 0.6, what + ", picture, % of pixels");
}

void TestSettings()
{
  Scene truth(false);
  Scene scene(true);
  Settings settings;
  truth.Set(settings);
  scene.Set(settings);
  Compare(truth, scene, "at first");
  const vtkMTimeType built = scene.Instanced->GetGlyphMapper()->GetMTime();
  vtkSmartPointer<vtkImageData> before = Picture(scene.Stage.Window);
  const auto test = [&](const std::string& what) {
    truth.Set(settings);
    scene.Set(settings);
    Compare(truth, scene, what);
    const vtkSmartPointer<vtkImageData> after = Picture(scene.Stage.Window);
    RELIEVO_CHECK_THAT(
      FailuresOf([&]() { SamePicture(before, after, what); }) > 0, what + " changes nothing");
    before = after;
  };
  settings.Growth = 0.4;
  test("growth");
  settings.Growth = 1.;
  settings.RepellerRadius = 1.2;
  test("repeller");
  settings.Repeller[0] = -0.9;
  test("another place");
  settings.RestSize = 0.4;
  test("size at rest");
  settings.Transition = 0.2;
  test("transition");
  // The instances were not made again.
  RELIEVO_CHECK(scene.Instanced->GetGlyphMapper()->GetMTime() == built);
  // The filter's own settings of sizes are of no effect.
  const auto drawn = Picture(scene.Stage.Window);
  scene.Filter->SetGrowth(0.1);
  scene.Filter->SetRepellerRadius(3.);
  RELIEVO_CHECK(relievoTest::SamePicture(drawn, Picture(scene.Stage.Window), "filter's settings"));
}

// With the whole grid and no transition, all cubes outside have the size at rest.
void TestNoTransition()
{
  Scene truth(false);
  Scene scene(true);
  Settings settings;
  settings.Transition = 0.;
  settings.RestSize = 0.3;
  truth.Set(settings);
  scene.Set(settings);
  scene.Filter->SetTransition(0.);
  Compare(truth, scene, "no transition");
}

// Settings that are given again change nothing, nor do those that are not finite.
void TestSame()
{
  Scene scene(true);
  Settings settings;
  settings.RepellerRadius = 1.2;
  scene.Set(settings);
  const auto drawn = Picture(scene.Stage.Window);
  const vtkMTimeType before = scene.Instanced->GetMTime();
  scene.Set(settings);
  scene.Instanced->SetCellSize(0.25, 0.2, 0.3);
  RELIEVO_CHECK(scene.Instanced->GetMTime() == before);
  for (const double invalid : { double(NAN), double(INFINITY) })
  {
    ExpectMessage expect("not finite");
    scene.Instanced->SetTransition(invalid);
    scene.Instanced->SetRestSize(NAN);
    scene.Instanced->SetGrowth(NAN);
    scene.Instanced->SetRepeller(invalid, 0., 0.);
    scene.Instanced->SetRepellerRadius(invalid);
    scene.Instanced->SetCellSize(0.25, invalid, 0.3);
    RELIEVO_CHECK(expect.Count() == 6);
  }
  RELIEVO_CHECK(scene.Instanced->GetMTime() == before);
  RELIEVO_CHECK(relievoTest::SamePicture(drawn, Picture(scene.Stage.Window), "not finite"));
}

void TestBounds()
{
  Scene scene(true);
  Settings settings;
  settings.RestSize = 1.;
  settings.Growth = 1.;
  scene.Set(settings);
  Picture(scene.Stage.Window);
  double bounds[6];
  for (int again = 0; again < 3; ++again)
  {
    scene.Actor->GetBounds(bounds);
  }
  const double box[6] = { -1.5, 1.5, -1.2, 1.2, -1.8, 1.8 };
  for (int i = 0; i < 6; ++i)
  {
    const double out = (i % 2 ? 1. : -1.) * (bounds[i] - box[i]);
    // Half a cell, and about as much by VTK's mapper.
    RELIEVO_CHECK_THAT(out > -1e-6 && out < 0.31, "bounds " + std::to_string(bounds[i]));
  }
  settings.Repeller[0] = 1.4;
  settings.RepellerRadius = 2.;
  scene.Set(settings);
  scene.Actor->GetBounds(bounds);
  RELIEVO_CHECK_THAT(bounds[1] > 3.4 && bounds[1] < 3.6, std::to_string(bounds[1]));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testVoxelCubesActor)
{
  relievoTest::Session session;
  TestSettings();
  TestNoTransition();
  TestSame();
  TestBounds();
  return session.Result();
}
}
