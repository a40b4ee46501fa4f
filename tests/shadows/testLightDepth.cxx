// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layer `light_depth`: the depths in the maps of a sun, a spot and a lamp straight above a box
// on a ground, whose distances along the axis are known.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLightDepthStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace testLightDepth
{
namespace
{
constexpr int Width = 240;
constexpr int Height = 160;
constexpr double Top = 0.5; // of the box, above the ground
constexpr double Above = 5.0;

void Add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

struct Scene
{
  vtkSmartPointer<vtkRenderWindow> Window = relievoTest::MakeWindow(Width, Height);
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;

  Scene(bool positional, double cone)
  {
    this->Window->AddRenderer(this->Renderer);
    vtkNew<vtkPlaneSource> ground;
    ground->SetOrigin(-2.0, -2.0, 0.0);
    ground->SetPoint1(2.0, -2.0, 0.0);
    ground->SetPoint2(-2.0, 2.0, 0.0);
    Add(this->Renderer, ground);
    this->AddBox(-0.5, 0.5);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(0.0, 0.0, Above);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Light->SetPositional(positional);
    this->Light->SetConeAngle(cone);
    vtkNew<vtkLight> other; // light 0 casts none
    other->SetLightTypeToHeadlight();
    other->SetIntensity(0.2);
    this->Renderer->AddLight(other);
    this->Renderer->AddLight(this->Light);
    this->Renderer->GetActiveCamera()->SetPosition(3.0, -4.0, 5.0);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Frame->ShadowsOn();
  }

  void AddBox(double from, double to)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(from, to, -0.25, 0.25, 0.0, Top);
    Add(this->Renderer, box);
  }

  vtkDataArray* Read()
  {
    this->Source->SetRenderer(this->Renderer);
    this->Source->RemoveAllLayers();
    this->Source->AddLayer("light_depth");
    this->Source->Update();
    vtkDataArray* found = this->Source->GetOutput()->GetPointData()->GetArray("light_depth");
    RELIEVO_CHECK(found && found->GetNumberOfTuples() == vtkIdType(Width) * Height);
    return found;
  }

  vtkRelievoStage* GetStage() { return this->Frame->GetStage("light_depth"); }

  vtkRelievoPass* Frame = nullptr;
  vtkNew<vtkRelievoLayerSource> Source;
};

// How many pixels have the value, and how many any finite one.
std::pair<int, int> Count(vtkDataArray* depths, double value)
{
  std::pair<int, int> found;
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    const double depth = depths->GetTuple1(i);
    found.first += std::abs(depth - value) < 2e-4 ? 1 : 0;
    found.second += std::isinf(depth) ? 0 : 1;
  }
  return found;
}

void TestSun()
{
  Scene scene(false, 90.0);
  const relievoTest::GLCheck gl(scene.Window);
  scene.AddBox(1.5, 1.75);
  vtkDataArray* depths = scene.Read();
  // From the near plane: the box's top and the ground are its height apart, in their proportion.
  double nearest = 1e300;
  double farthest = 0.0;
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    if (!std::isinf(depths->GetTuple1(i)))
    {
      nearest = std::min(nearest, depths->GetTuple1(i));
      farthest = std::max(farthest, depths->GetTuple1(i));
    }
  }
  RELIEVO_CHECK_AT_MOST(std::abs(farthest - nearest - Top), 1e-4, "the box's height");
  const double top = Count(depths, nearest).first;
  const double ground = Count(depths, farthest).first;
  RELIEVO_CHECK_AT_MOST(
    std::abs(top / ground - 1.25 / 1.0), 0.02, "the boxes' share of the ground");
  RELIEVO_CHECK(Count(depths, 0.0).second == top + ground);
  RELIEVO_CHECK(scene.GetStage()->GetReason() == "shows 1 map of light 1");
}

// Where no shadow can fall, the ground takes no texels.
void TestWideGround()
{
  Scene scene(false, 90.0);
  vtkDataArray* depths = scene.Read();
  double range[2];
  depths->GetFiniteRange(range);
  RELIEVO_CHECK_AT_MOST(range[1] - range[0], 1e-4, "depths of the box's top alone");
  RELIEVO_CHECK(Count(depths, range[0]).second == Height * Height / 2);
}

void TestSpotAndLamp()
{
  for (const double cone : { 40.0, 180.0 })
  {
    Scene scene(true, cone);
    const relievoTest::GLCheck gl(scene.Window);
    scene.AddBox(1.5, 1.75);
    scene.AddBox(-1.75, -1.5);
    vtkDataArray* depths = scene.Read();
    const std::string what = cone < 90.0 ? "spot: " : "lamp: ";
    const auto ground = Count(depths, Above);
    const auto top = Count(depths, Above - Top);
    // The tops are nearer and look larger. The outer boxes show a side as well, a trapezoid.
    const double larger = Above / (Above - Top);
    const double tops = larger * larger * 0.5 * (1.0 + 2 * 0.25);
    const double sides = 2 * 1.5 * (larger - 1.0) * 0.5 * (0.5 + larger * 0.5);
    const double whole = larger * larger * 0.5 * (2 * 1.75);
    RELIEVO_CHECK_AT_MOST(
      std::abs(top.first * (whole - tops - sides) / (ground.first * tops) - 1.0), 0.02,
      what + "the tops' share of the ground");
    RELIEVO_CHECK(top.first + ground.first > 0.92 * ground.second && ground.first > 1000);
  }
}

// Selection of the light; no casting light; no shadows at all; no trace of the former state.
void TestWhichLight()
{
  Scene scene(false, 90.0);
  const int finite = Count(scene.Read(), 0.0).second;
  RELIEVO_CHECK(finite > 1000);
  scene.GetStage()->SetParameter("light", "1");
  RELIEVO_CHECK(Count(scene.Read(), 0.0).second == finite);
  scene.GetStage()->SetParameter("light", "0");
  RELIEVO_CHECK(Count(scene.Read(), 0.0).second == 0);
  RELIEVO_CHECK(scene.GetStage()->GetReason() == "light 0 casts no shadow");
  scene.GetStage()->SetParameter("light", "-1");
  RELIEVO_CHECK(Count(scene.Read(), 0.0).second == finite);

  // Shadows need not be seen; exact ones have no maps.
  scene.Frame->ShadowsOff();
  RELIEVO_CHECK(Count(scene.Read(), 0.0).second == finite);
  scene.Frame->GetShadowStage()->SetMethodToExact();
  RELIEVO_CHECK(Count(scene.Read(), 0.0).second == 0);
  RELIEVO_CHECK(scene.GetStage()->GetReason() == "light 1 has no map");
  scene.Frame->GetShadowStage()->SetMethodToMap();
  scene.Frame->ShadowsOn();

  scene.Frame->SetDisplayLayer("light_depth");
  scene.Window->Render();
  RELIEVO_CHECK(scene.GetStage()->GetReasonCode() == "ran");
  scene.Frame->SetDisplayLayer("");
  scene.Window->Render();
  RELIEVO_CHECK(scene.GetStage()->GetReasonCode() == "not_asked");
  RELIEVO_CHECK(scene.GetStage()->GetBytesHeld() == 0);
}
}

RELIEVO_TEST_CASE(testLightDepth)
{
  relievoTest::Session session;
  TestSun();
  TestWideGround();
  TestSpotAndLamp();
  TestWhichLight();
  return session.Result();
}
}
