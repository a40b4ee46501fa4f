// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ground.h"

#include "GroundSky.h"
#include "OptionRows.h"
#include "Triples.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace look
{
namespace
{
constexpr int Sectors = 96;
constexpr int InnerRings = 32; // where the scene hides much of the sky
constexpr int Rings = 42;
constexpr double Near = 1.6; // in radii of the scene
constexpr double Reach = 3.0;
constexpr double Solid = 1.2; // radius at which it begins to fade

// The opacity at the rim, in bytes. VTK's translucent pass divides by at least 0.01, and so darkens
// surfaces of less opacity: the ground would have a dark ring. A black ground fades to 0: it has no
// ring, but would have an edge in front of an environment.
constexpr long LeastAlpha = 3;

// Opacity: opaque inside, least at the rim, smooth between.
unsigned char GetAlpha(double radii, long least)
{
  const double t = std::clamp((Reach - radii) / (Reach - Solid), 0.0, 1.0);
  return static_cast<unsigned char>(std::max(least, std::lround(255.0 * t * t * (3.0 - 2.0 * t))));
}

double GetRadius(int ring)
{
  return ring <= InnerRings ? Near * ring / InnerRings
                            : Near + (Reach - Near) * (ring - InnerRings) / (Rings - InnerRings);
}

// The displayed share of the light that reaches a place from which all of the sky is hidden, in
// pictures without shadows: about that of a preset's first light, whose strength is unknown here.
constexpr double PlainDirect = 0.5;

// The displayed share of the light where this share of the sky, of linear light, is hidden.
double GetPlainContact(double hidden)
{
  return std::pow(1.0 - hidden * (1.0 - std::pow(PlainDirect, 2.2)), 1.0 / 2.2);
}

unsigned char MakeByte(double value)
{
  return static_cast<unsigned char>(std::lround(255.0 * value));
}

// Neighbours look in other directions, turned by these quarters of the angle between two. Means of
// neighbours, in which all four have the same weight, know four times as many directions.
std::size_t GetQuarter(int ring, int sector)
{
  return static_cast<std::size_t>(2 * (ring % 2) + (ring + sector) % 2);
}

using HiddenSky = std::vector<float>; // of each point

HiddenSky Smooth(HiddenSky found)
{
  // All sectors have the same point in the middle.
  const float middle = std::accumulate(found.begin(), found.begin() + Sectors, 0.0F) / Sectors;
  std::fill_n(found.begin(), Sectors, middle);
  HiddenSky smooth = found;
  for (int ring = 1; ring < Rings; ++ring)
  {
    for (int sector = 0; sector < Sectors; ++sector)
    {
      float sum = 0.0F;
      for (int dr = -1; dr <= 1; ++dr)
      {
        for (int ds = -1; ds <= 1; ++ds)
        {
          const float weight = (dr == 0 ? 2.0F : 1.0F) * (ds == 0 ? 2.0F : 1.0F) / 16.0F;
          sum += weight * found[(ring + dr) * Sectors + (sector + ds + Sectors) % Sectors];
        }
      }
      smooth[ring * Sectors + sector] = sum;
    }
  }
  return smooth;
}

vtkPolyData* GetDisc(vtkActor* ground)
{
  return vtkPolyData::SafeDownCast(ground->GetMapper()->GetInputDataObject(0, 0));
}

// The colours where nothing hides the sky, and the hidden share of the sky.
vtkFloatArray* GetCatcher(vtkActor* ground)
{
  return vtkFloatArray::SafeDownCast(
    GetDisc(ground)->GetPointData()->GetArray(vtkRelievoShadowCatcher::GetColorsName()));
}

vtkUnsignedCharArray* GetColors(vtkActor* ground)
{
  vtkPolyData* disc = GetDisc(ground);
  return vtkUnsignedCharArray::SafeDownCast(disc->GetPointData()->GetScalars());
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeGround(
  const double bounds[6], int upAxis, const std::array<double, 3>& color, vtkRenderer* renderer)
{
  const auto up = static_cast<std::size_t>(upAxis);
  const std::size_t first = (up + 1) % 3; // first x second = up
  const std::size_t second = (up + 2) % 3;
  std::array<double, 3> middle{};
  std::array<double, 3> half{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    half[axis] = 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  const double radius = Length(half);
  middle[up] -= half[up] + 1e-4 * radius; // avoids z-fighting with flat bottoms

  vtkNew<vtkPoints> points;
  HiddenSky hidden;
  const std::optional<GroundSky> sky = renderer
    ? std::optional<GroundSky>(std::in_place, renderer, bounds, upAxis, middle[up])
    : std::nullopt;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples((Rings + 1) * Sectors);
  for (int ring = 0; ring <= Rings; ++ring)
  {
    const double radii = GetRadius(ring);
    for (int sector = 0; sector < Sectors; ++sector)
    {
      const double angle = 2.0 * vtkMath::Pi() * sector / Sectors;
      std::array<double, 3> point = middle;
      point[first] += radius * radii * std::cos(angle);
      point[second] += radius * radii * std::sin(angle);
      points->InsertNextPoint(point.data());
      hidden.push_back(static_cast<float>(
        sky && ring < Rings ? sky->GetHidden(point, GetQuarter(ring, sector)) : 0.0));
    }
  }
  hidden = Smooth(std::move(hidden));
  vtkNew<vtkFloatArray> catcher;
  catcher->SetName(vtkRelievoShadowCatcher::GetColorsName());
  catcher->SetNumberOfComponents(4);
  for (const float share : hidden)
  {
    catcher->InsertNextTuple4(0.0, 0.0, 0.0, share);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType ring = 0; ring < Rings; ++ring)
  {
    for (vtkIdType sector = 0; sector < Sectors; ++sector)
    {
      const vtkIdType next = (sector + 1) % Sectors;
      const vtkIdType corners[4] = { ring * Sectors + sector, (ring + 1) * Sectors + sector,
        (ring + 1) * Sectors + next, ring * Sectors + next };
      cells->InsertNextCell(4, corners);
    }
  }
  vtkNew<vtkPolyData> disc;
  disc->SetPoints(points);
  disc->SetPolys(cells);
  disc->GetPointData()->SetScalars(colors);
  disc->GetPointData()->AddArray(catcher);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(disc);
  vtkRelievoShadowCatcher::MapColors(mapper);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->ForceTranslucentOn();
  vtkProperty* property = actor->GetProperty();
  property->BackfaceCullingOn(); // invisible from below
  property->SetInterpolationToFlat();
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
  vtkRelievoShadowCatcher::Make(actor);
  SetGroundColor(actor, color.data());
  return actor;
}

//------------------------------------------------------------------------------
void GetGroundColor(vtkActor* ground, double color[3])
{
  vtkFloatArray* catcher = GetCatcher(ground);
  for (int i = 0; i < 3; ++i)
  {
    color[i] = catcher->GetTypedComponent(0, i);
  }
}

//------------------------------------------------------------------------------
void SetGroundColor(vtkActor* ground, const double color[3])
{
  vtkUnsignedCharArray* colors = GetColors(ground);
  vtkFloatArray* catcher = GetCatcher(ground);
  const long least = color[0] + color[1] + color[2] > 0.0 ? LeastAlpha : 0;
  for (vtkIdType point = 0; point < colors->GetNumberOfTuples(); ++point)
  {
    const int ring = static_cast<int>(point) / Sectors;
    colors->SetTypedComponent(point, 3, GetAlpha(GetRadius(ring), least));
    const double contact = GetPlainContact(catcher->GetTypedComponent(point, 3));
    for (int i = 0; i < 3; ++i)
    {
      catcher->SetTypedComponent(point, i, static_cast<float>(color[i]));
      colors->SetTypedComponent(point, i, MakeByte(catcher->GetTypedComponent(point, i) * contact));
    }
  }
  catcher->Modified();
  colors->Modified();
  GetDisc(ground)->Modified();
}

//------------------------------------------------------------------------------
void AddGroundOption(OptionRows& rows, std::optional<bool>& ground)
{
  rows
    .AddChoice("--ground", "ON", { "off", "on" },
      "on or off: a ground below the scene that catches its shadows, only in the picture "
      "(on with the lights of studio and town)",
      [&ground](std::size_t place) { ground = place == 1; })
    .NamedIn("Scene", "Ground");
}
}
