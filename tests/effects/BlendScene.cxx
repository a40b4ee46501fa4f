// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendScene.h"

#include "Check.h"
#include "Props.h"
#include "SrgbCurve.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoLamps.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
namespace
{
constexpr int Width = 60;
constexpr int Height = 40;

struct Pane
{
  int From[2]; // pixels, lower left
  int To[2];   // upper right, not included
  double Z;
  glm::dvec3 Color;
  double Opacity;
};

const Pane PaneTable[2] = {
  { { 6, 4 }, { 40, 36 }, 0.6, glm::dvec3(0.9, 0.3, 0.1), 0.5 },
  { { 20, 8 }, { 54, 32 }, 0.8, glm::dvec3(0.2, 0.6, 1.0), 0.3 },
};

// One unit is ten pixels, and the origin is in the middle.
vtkSmartPointer<vtkActor> AddSquare(
  vtkRenderer* renderer, const int from[2], const int to[2], double z)
{
  vtkNew<vtkPlaneSource> plane;
  const double left = 0.1 * (from[0] - Width / 2);
  const double right = 0.1 * (to[0] - Width / 2);
  const double bottom = 0.1 * (from[1] - Height / 2);
  plane->SetOrigin(left, bottom, z);
  plane->SetPoint1(right, bottom, z);
  plane->SetPoint2(left, 0.1 * (to[1] - Height / 2), z);
  plane->Update();
  return AddActor(renderer, plane->GetOutput());
}

vtkSmartPointer<vtkProp> MakeVolume()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  image->SetSpacing(0.8, 0.6, 0.1);
  image->SetOrigin(-0.2, -0.6, 1.1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 27, 100);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.05);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.4);
  opacity->AddPoint(255.0, 0.4);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.3, 0.9, 0.4);
  color->AddRGBPoint(255.0, 0.3, 0.9, 0.4);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  return volume;
}
}

//------------------------------------------------------------------------------
glm::dvec4 Over(const glm::dvec4& front, const glm::dvec4& behind)
{
  return front + (1.0 - front.a) * behind;
}

//------------------------------------------------------------------------------
double GetError(const glm::dvec4& value, const glm::dvec4& expected)
{
  double worst = 0.0;
  for (int c = 0; c < 4; ++c)
  {
    worst = std::max(worst, std::abs(value[c] - expected[c]) / (std::abs(expected[c]) + 0.05));
  }
  return worst;
}

//------------------------------------------------------------------------------
glm::dvec4 GetColor(const Layers& layers, const std::string& name, int x, int y)
{
  return { layers.Value(name, x, y, 0), layers.Value(name, x, y, 1), layers.Value(name, x, y, 2),
    layers.Value(name, x, y, 3) };
}

//------------------------------------------------------------------------------
BlendScene::BlendScene(int samples)
{
  const int from[2] = { 4, 10 };
  const int to[2] = { 56, 30 };
  this->Wall = AddSquare(this->Renderer, from, to, 0.0);
  this->Wall->GetProperty()->SetColor(0.7, 0.5, 0.3);
  this->Wall->GetProperty()->SetDiffuse(0.5);
  for (int i = 0; i < 2; ++i)
  {
    const Pane& pane = PaneTable[i];
    this->Panes[i] = AddSquare(this->Renderer, pane.From, pane.To, pane.Z);
    vtkProperty* property = this->Panes[i]->GetProperty();
    property->LightingOff();
    property->SetColor(pane.Color.r, pane.Color.g, pane.Color.b);
    property->SetOpacity(pane.Opacity);
  }
  this->Renderer->SetBackground(0.1, 0.15, 0.3);
  this->Window = MakeWindow(Width, Height, this->Renderer);
  this->Window->SetMultiSamples(samples);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.05 * Height);
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 9.0);
  this->Frame = vtkRelievoPass::Attach(this->Renderer);
  this->Lamps = vtkRelievoLampsStage::SafeDownCast(this->Frame->GetStage("lamps"));
  this->Blend = vtkRelievoBlendStage::SafeDownCast(this->Frame->GetStage("blend"));
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.2, 0.5);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(places);
  lamps->SetRadius(3.0);
  lamps->SetIntensity(2.5);
  this->Lamps->AddPoints(lamps);
}

//------------------------------------------------------------------------------
void BlendScene::ShowPanes(bool on)
{
  for (auto& pane : this->Panes)
  {
    pane->SetVisibility(on);
  }
}

//------------------------------------------------------------------------------
void BlendScene::ShowVolume(bool on)
{
  if (!this->Volume)
  {
    this->Volume = MakeVolume();
    this->Renderer->AddViewProp(this->Volume);
  }
  this->Volume->SetVisibility(on);
}

//------------------------------------------------------------------------------
Layers BlendScene::Read(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    this->Frame->RequestLayer(name);
  }
  this->Window->Render();
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(this->Frame->ReadLayers(names, image));
  this->Frame->ReleaseLayers();
  return Layers(image);
}

//------------------------------------------------------------------------------
double BlendScene::GetNearest(int x, int y) const
{
  double nearest = -1e30;
  for (int i = 0; i < 2; ++i)
  {
    if (this->IsBefore(i, x, y))
    {
      nearest = std::max(nearest, PaneTable[i].Z);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
bool BlendScene::IsBefore(int i, int x, int y) const
{
  const Pane& pane = PaneTable[i];
  return this->Panes[i]->GetVisibility() && x >= pane.From[0] && x < pane.To[0] &&
    y >= pane.From[1] && y < pane.To[1];
}

//------------------------------------------------------------------------------
glm::dvec4 BlendScene::GetBlend(int x, int y, Blending blending) const
{
  // VTK blends values for display, not light.
  glm::dvec4 sum(0.0);
  double opacities = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    if (this->IsBefore(i, x, y))
    {
      const Pane& pane = PaneTable[i];
      const glm::dvec4 layer(pane.Opacity * pane.Color, pane.Opacity);
      sum = blending == Blending::Sorted
        ? Over(layer, sum)
        : glm::dvec4(glm::dvec3(sum) + glm::dvec3(layer), Over(layer, sum).a);
      opacities += pane.Opacity;
    }
  }
  if (!(sum.a > 0.0))
  {
    return sum;
  }
  const double weight = blending == Blending::Sorted ? sum.a : opacities;
  for (int c = 0; c < 3; ++c)
  {
    sum[c] = sum.a * LinearFromSrgb(sum[c] / weight);
  }
  return sum;
}
}
