// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LampWindows.h"

#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRenderer.h>

#include <cmath>
#include <random>

namespace relievoBench
{
namespace
{
constexpr double Box[3] = { 6., 2., 6. };
}

//------------------------------------------------------------------------------
double RadiusFor(int lamps, double reaching)
{
  constexpr double Pi = 3.14159265358979323846;
  return std::cbrt(reaching * Box[0] * Box[1] * Box[2] / (lamps * 4. / 3. * Pi));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLamps(int count)
{
  std::mt19937 random(static_cast<unsigned int>(count));
  std::uniform_real_distribution<double> share(0., 1.);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(
      Box[0] * (share(random) - 0.5), Box[1] * share(random), Box[2] * (share(random) - 0.5));
    colors->InsertNextTuple3(share(random), share(random), share(random));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(colors);
  return data;
}

//------------------------------------------------------------------------------
LitWindow::LitWindow(vtkPolyData* mesh, int pixels, vtkPolyData* lamps, double radius, int way)
  : Window(new SceneWindow(mesh, pixels, pixels))
{
  this->Lamps->SetInputData(lamps);
  this->Lamps->SetRadius(radius);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Window->Scene.Renderer);
  this->Stage = vtkRelievoLampsStage::SafeDownCast(frame->GetStage("lamps"));
  this->Stage->AddPoints(this->Lamps);
  this->Stage->SetWay(way);
}

//------------------------------------------------------------------------------
relievoTest::Timed LitWindow::Frame()
{
  relievoTest::Timed frame = this->Window->Frame();
  frame.Prepare = [this]() { this->Lamps->Modified(); };
  return frame;
}

//------------------------------------------------------------------------------
void LitWindow::Count(double& computed, double& reaching)
{
  vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Window->Scene.Renderer);
  frame->RequestLayer("lamp_evaluations");
  this->Window->Window->Render();
  const auto facts = this->Stage->GetFacts();
  computed = facts.at("lamps_evaluated_per_pixel").ToDouble();
  reaching = facts.at("lamps_reaching_per_pixel").ToDouble();
  frame->ReleaseLayers();
}

//------------------------------------------------------------------------------
std::unique_ptr<SceneWindow> MakePeer(vtkPolyData* mesh, int pixels, vtkPolyData* lamps)
{
  std::unique_ptr<SceneWindow> window(new SceneWindow(mesh, pixels, pixels));
  vtkDataArray* colors = lamps->GetPointData()->GetArray("color");
  for (vtkIdType i = 0; i < lamps->GetNumberOfPoints(); ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->PositionalOn();
    light->SetConeAngle(180.);
    light->SetPosition(lamps->GetPoint(i));
    light->SetColor(colors->GetTuple(i));
    light->SetAttenuationValues(1., 0., 10.);
    window->Scene.Renderer->AddLight(light);
  }
  return window;
}
}
