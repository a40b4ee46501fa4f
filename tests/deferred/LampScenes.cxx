// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LampScenes.h"

#include "Check.h"
#include "Layers.h"
#include "PointArrays.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace relievoTest
{
namespace
{
void Add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source, const glm::dvec3& place)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(place.x, place.y, place.z);
  renderer->AddActor(actor);
}
}

//------------------------------------------------------------------------------
LampScene::LampScene(int width, int height, const glm::dvec3& offset)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->SetRadius(0.8);
  Add(this->Renderer, sphere, offset + glm::dvec3(-0.7, 0.8, 0.0));
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 1.0, 0.0);
  cone->SetHeight(1.5);
  cone->SetResolution(50);
  Add(this->Renderer, cone, offset + glm::dvec3(1.0, 0.75, 0.4));
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-3.0, 0.0, 3.0);
  floor->SetPoint1(3.0, 0.0, 3.0);
  floor->SetPoint2(-3.0, 0.0, -3.0);
  Add(this->Renderer, floor, offset);
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-3.0, 0.0, -2.0);
  wall->SetPoint1(3.0, 0.0, -2.0);
  wall->SetPoint2(-3.0, 2.0, -2.0);
  Add(this->Renderer, wall, offset);
  this->Window = MakeWindow(width, height, this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(offset.x + 2.5, offset.y + 3.0, offset.z + 6.0);
  camera->SetFocalPoint(offset.x, offset.y + 0.5, offset.z);
  camera->SetViewAngle(40.0);
  camera->SetClippingRange(1.0, 16.0);
  this->Frame = vtkRelievoPass::Attach(this->Renderer);
  this->Stage = vtkRelievoLampsStage::SafeDownCast(this->Frame->GetStage("lamps"));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoLamps> LampScene::AddLamps(const std::vector<Lamp>& lamps)
{
  auto set = vtkSmartPointer<vtkRelievoLamps>::New();
  set->SetInputData(ToPolyData(lamps));
  this->Stage->AddPoints(set);
  return set;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> LampScene::Read(const std::vector<std::string>& layers)
{
  for (const std::string& layer : layers)
  {
    this->Frame->RequestLayer(layer);
  }
  this->Window->Render();
  auto image = vtkSmartPointer<vtkImageData>::New();
  RELIEVO_CHECK(this->Frame->ReadLayers(layers, image));
  this->Frame->ReleaseLayers();
  return image;
}

//------------------------------------------------------------------------------
std::vector<Lamp> RandomLamps(int count, double radius, bool white, const glm::dvec3& offset)
{
  std::mt19937 random(static_cast<unsigned int>(count));
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Lamp> lamps;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 place(
      6.0 * share(random) - 3.0, 2.5 * share(random), 6.0 * share(random) - 3.0);
    const double size = radius * (0.5 + share(random));
    const double intensity = 0.2 + share(random);
    const glm::dvec3 color =
      white ? glm::dvec3(1.0) : glm::dvec3(share(random), share(random), share(random));
    lamps.push_back({ place + offset, size, intensity, color });
  }
  return lamps;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToPolyData(const std::vector<Lamp>& lamps)
{
  return MakePoints(lamps, &Lamp::Place,
    { { "radius", &Lamp::Radius }, { "intensity", &Lamp::Intensity } }, &Lamp::Color);
}

//------------------------------------------------------------------------------
LampSum SumLight(const std::vector<Lamp>& lamps, int falloff, const glm::dvec3& attenuation,
  const glm::dvec3& place, const glm::dvec3& normal)
{
  LampSum sum;
  for (const Lamp& lamp : lamps)
  {
    const glm::dvec3 to = lamp.Place - place;
    const double d = glm::length(to);
    const double r = lamp.Radius;
    if (!(d < r))
    {
      continue;
    }
    ++sum.Reaching;
    double share = 1.0 - d / r;
    double slope = 1.0 / r;
    if (falloff == vtkRelievoLamps::INVERSE_SQUARE)
    {
      const double nearest = std::max(d, 0.01 * r);
      const double window = 1.0 - std::pow(d / r, 4.0);
      share = window * window / (nearest * nearest);
      slope = 2.0 / (nearest * nearest * nearest) + 8.0 / (r * nearest * nearest);
    }
    else if (falloff == vtkRelievoLamps::VTK)
    {
      share = 1.0 / (attenuation.x + attenuation.y * d + attenuation.z * d * d);
      slope = share * share * (attenuation.y + 2.0 * attenuation.z * d);
    }
    const double cosine = d > 0.0 ? std::max(0.0, glm::dot(normal, to) / d) : 0.0;
    sum.Light += lamp.Intensity * share * cosine * lamp.Color;
    sum.Slope += std::abs(lamp.Intensity) * std::max({ lamp.Color.x, lamp.Color.y, lamp.Color.z }) *
      (slope * cosine + share / std::max(d, 1e-12));
  }
  return sum;
}

//------------------------------------------------------------------------------
long long CheckLight(vtkImageData* image, const std::vector<Lamp>& lamps, int falloff,
  const glm::dvec3& attenuation, const std::string& what, double place)
{
  const Layers layers(image);
  long long lit = 0;
  double worst = 0.0; // relative to the limit
  double dark = 0.0;  // light of the background
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const glm::dvec3 light = layers.Vector("light", x, y);
      if (!std::isfinite(layers.Value("depth", x, y)))
      {
        dark = std::max({ dark, std::abs(light.x), std::abs(light.y), std::abs(light.z) });
        continue;
      }
      const LampSum truth = SumLight(lamps, falloff, attenuation, layers.Vector("position", x, y),
        layers.Vector("normal", x, y));
      for (int c = 0; c < 3; ++c)
      {
        // Half a step of a half float, a step of 6e-8 next to 0; the float's sum of the lamps.
        const double allowed = std::abs(truth.Light[c]) / 2048.0 + 6e-8 +
          place * layers.Value("range", x, y) * truth.Slope +
          1.2e-7 * std::abs(truth.Light[c]) * (4.0 + 0.5 * truth.Reaching);
        worst = std::max(worst, std::abs(light[c] - truth.Light[c]) / allowed);
      }
      lit += truth.Light.x + truth.Light.y + truth.Light.z > 1e-3 ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1.0, what + ": light, largest error of what is allowed");
  RELIEVO_CHECK(dark == 0.0);
  return lit;
}
}
