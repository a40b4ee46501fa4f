// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FogScene.h"

#include "Check.h"
#include "FogTruth.h"
#include "Props.h"
#include "Stage.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>

#include <cmath>

namespace relievoTest
{
namespace
{
constexpr double Background[3] = { 0.2, 0.3, 0.4 };

// IEC 61966-2-1.
double LinearFromSrgb(double v)
{
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double SrgbFromLinear(double v)
{
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1. / 2.4) - 0.055;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFogPoints(const std::vector<FogSphere>& spheres)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  vtkNew<vtkDoubleArray> densities;
  vtkNew<vtkDoubleArray> colors;
  radii->SetName("radius");
  densities->SetName("density");
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  for (const FogSphere& sphere : spheres)
  {
    points->InsertNextPoint(sphere.Center.x, sphere.Center.y, sphere.Center.z);
    radii->InsertNextValue(sphere.Radius);
    densities->InsertNextValue(sphere.Density);
    colors->InsertNextTuple3(sphere.Color.x, sphere.Color.y, sphere.Color.z);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(densities);
  data->GetPointData()->AddArray(colors);
  return data;
}

//------------------------------------------------------------------------------
FogScene::FogScene(int width, int height, const glm::dvec3& origin)
  : Window(MakeWindow(width, height, Renderer))
  , Origin(origin)
{
  // A wall of 3 x 3 behind a ball; sky around.
  auto wall = AddActor(this->Renderer, MakeBox(3., 3., 0.1));
  wall->SetPosition(origin.x, origin.y + 0.5, origin.z - 1.2);
  wall->GetProperty()->SetColor(0.6, 0.6, 0.5);
  auto ball = AddActor(this->Renderer, MakeBall(0.5));
  ball->SetPosition(origin.x, origin.y + 0.5, origin.z);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
  this->Renderer->SetBackgroundAlpha(1.);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(origin.x, origin.y + 0.6, origin.z + 4.5);
  camera->SetFocalPoint(origin.x, origin.y + 0.5, origin.z);
  camera->SetViewAngle(50.);
  camera->SetClippingRange(0.5, 12.);
  this->Frame = vtkRelievoPass::Attach(this->Renderer);
  this->Stage = vtkRelievoFogStage::SafeDownCast(this->Frame->GetStage("fog"));
  this->Stage->AddFog(this->Fog);
}

//------------------------------------------------------------------------------
void FogScene::Set(const std::vector<FogSphere>& spheres)
{
  this->Spheres = spheres;
  for (FogSphere& sphere : this->Spheres)
  {
    sphere.Center += this->Origin;
  }
  this->Fog->SetInputData(MakeFogPoints(this->Spheres));
}

//------------------------------------------------------------------------------
void FogScene::AddGlass()
{
  auto glass = AddActor(this->Renderer, MakeBox(2., 2., 0.01));
  glass->SetPosition(this->Origin.x, this->Origin.y + 0.5, this->Origin.z + 1.5);
  glass->GetProperty()->SetOpacity(0.4);
}

//------------------------------------------------------------------------------
Layers FogScene::Read(const std::vector<std::string>& names)
{
  // As the stage reads it: refined depths are computed for readers alone.
  this->Frame->GetLayersStage()->RefineDepthOff();
  for (const std::string& name : names)
  {
    this->Frame->RequestLayer(name);
  }
  this->Window->Render();
  vtkNew<vtkImageData> image;
  for (const std::string& name : names)
  {
    RELIEVO_CHECK(this->Frame->ReadLayer(name, image));
    this->Frame->ReleaseLayer(name);
  }
  return Layers(image);
}

//------------------------------------------------------------------------------
FogErrors FogScene::Compare()
{
  this->Stage->EnabledOff();
  const vtkSmartPointer<vtkImageData> plain = Picture(this->Window);
  this->Stage->EnabledOn();
  const vtkSmartPointer<vtkImageData> fogged = Picture(this->Window);
  const Layers layers = this->Read({ "depth", "fog" });
  vtkRelievoFrameCamera view;
  view.Take(this->Renderer, nullptr);
  const bool linear = this->Stage->GetMode() == vtkRelievoFogStage::CHORD;
  const bool dominant = this->Stage->GetOverlap() == vtkRelievoFogStage::DOMINANT;
  std::vector<glm::dvec3> centers;
  for (const FogSphere& sphere : this->Spheres)
  {
    centers.emplace_back(view.WorldToView * glm::dvec4(sphere.Center, 1.));
  }
  FogErrors errors;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const double end = layers.Value("depth", x, y);
      double sum = 0.;
      glm::dvec3 color(0.);
      for (std::size_t i = 0; i < this->Spheres.size(); ++i)
      {
        const FogSphere& sphere = this->Spheres[i];
        const auto chord =
          static_cast<double>(ChordTruth(view, x + 0.5, y + 0.5, centers[i], sphere.Radius, end));
        const double depth = linear
          ? -std::log1p(-std::min(1. - 1e-7, sphere.Density * chord / (2. * sphere.Radius)))
          : sphere.Density * chord;
        if (!dominant)
        {
          sum += depth;
          color += depth * sphere.Color;
        }
        else if (depth > sum)
        {
          sum = depth;
          color = depth * sphere.Color;
        }
      }
      const double passes = std::exp(-sum);
      const double error = std::abs(passes - layers.Value("fog", x, y));
      errors.Passes = error > errors.Passes || std::isnan(error) ? error : errors.Passes;
      errors.Fogged += passes < 0.99 ? 1 : 0;
      errors.Sky += passes < 0.99 && std::isinf(end) ? 1 : 0;
      for (int i = 0; i < 3; ++i)
      {
        const double before = LinearFromSrgb(plain->GetScalarComponentAsDouble(x, y, 0, i) / 255.);
        const double after = before * passes + (sum > 0. ? color[i] / sum * (1. - passes) : 0.);
        // One level of the plain picture is more of the fogged one where fog lies over the dark.
        const double difference =
          std::abs(fogged->GetScalarComponentAsDouble(x, y, 0, i) - 255. * SrgbFromLinear(after));
        errors.Picture = std::max(errors.Picture, difference);
      }
    }
  }
  return errors;
}
}
