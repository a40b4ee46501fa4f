// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FogScene.h"

#include "FogTruth.h"
#include "PointArrays.h"
#include "Props.h"
#include "Stage.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFogPoints(const std::vector<FogSphere>& spheres)
{
  return MakePoints(spheres, &FogSphere::Center,
    { { "radius", &FogSphere::Radius }, { "density", &FogSphere::Density } }, &FogSphere::Color);
}

//------------------------------------------------------------------------------
FogScene::FogScene(int width, int height, const glm::dvec3& origin)
  : EffectScene(width, height, origin)
  , Stage(this->Frame->GetFogStage())
{
  // A wall of 3 x 3 behind a ball; sky around.
  this->Add(MakeBox(3., 3., 0.1), { 0., 0.5, -1.2 }, 0.6, 0.6, 0.5);
  this->Add(MakeBall(0.5), { 0., 0.5, 0. }, 0.9, 0.4, 0.2);
  this->LookFrom({ 0., 0.6, 4.5 }, { 0., 0.5, 0. });
  this->Stage->AddPoints(this->Fog);
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
  this->Add(MakeBox(2., 2., 0.01), { 0., 0.5, 1.5 }, 1., 1., 1.)->GetProperty()->SetOpacity(0.4);
}

//------------------------------------------------------------------------------
FogErrors FogScene::Compare()
{
  const EffectPictures pictures = this->Draw(this->Stage);
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
      errors.Transmittance =
        error > errors.Transmittance || std::isnan(error) ? error : errors.Transmittance;
      errors.Fogged += passes < 0.99 ? 1 : 0;
      errors.Sky += passes < 0.99 && std::isinf(end) ? 1 : 0;
      const glm::dvec3 added = sum > 0. ? color / sum * (1. - passes) : glm::dvec3(0.);
      errors.Picture = std::max(errors.Picture, pictures.GetError(x, y, passes, added));
    }
  }
  return errors;
}
}
