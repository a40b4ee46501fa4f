// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ground.h"

#include "Triples.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataSet.h"
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

namespace scene
{
namespace
{
constexpr int Sectors = 96;
constexpr int Rings = 16;
constexpr double Reach = 3.0; // in radii of the scene
constexpr double Solid = 1.2; // radius at which it begins to fade

// Opacity: opaque inside, 0 at the rim, smooth between.
unsigned char GetAlpha(double radii)
{
  const double t = std::clamp((Reach - radii) / (Reach - Solid), 0.0, 1.0);
  return static_cast<unsigned char>(std::lround(255.0 * t * t * (3.0 - 2.0 * t)));
}

unsigned char MakeByte(double value)
{
  return static_cast<unsigned char>(std::lround(255.0 * value));
}

vtkPolyData* GetDisc(vtkActor* ground)
{
  return vtkPolyData::SafeDownCast(ground->GetMapper()->GetInputDataObject(0, 0));
}

vtkUnsignedCharArray* GetColors(vtkActor* ground)
{
  vtkPolyData* disc = GetDisc(ground);
  return vtkUnsignedCharArray::SafeDownCast(disc->GetPointData()->GetScalars());
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeGround(
  const double bounds[6], int upAxis, const std::array<double, 3>& color)
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
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(4);
  for (int ring = 0; ring <= Rings; ++ring)
  {
    const double radii = Reach * ring / Rings;
    for (int sector = 0; sector < Sectors; ++sector)
    {
      const double angle = 2.0 * vtkMath::Pi() * sector / Sectors;
      std::array<double, 3> point = middle;
      point[first] += radius * radii * std::cos(angle);
      point[second] += radius * radii * std::sin(angle);
      points->InsertNextPoint(point.data());
      const unsigned char tuple[4] = { MakeByte(color[0]), MakeByte(color[1]), MakeByte(color[2]),
        GetAlpha(radii) };
      colors->InsertNextTypedTuple(tuple);
    }
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

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(disc);
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
  return actor;
}

//------------------------------------------------------------------------------
void GetGroundColor(vtkActor* ground, double color[3])
{
  for (int i = 0; i < 3; ++i)
  {
    color[i] = GetColors(ground)->GetComponent(0, i) / 255.0;
  }
}

//------------------------------------------------------------------------------
void SetGroundColor(vtkActor* ground, const double color[3])
{
  vtkUnsignedCharArray* colors = GetColors(ground);
  for (int i = 0; i < 3; ++i)
  {
    colors->FillTypedComponent(i, MakeByte(color[i]));
  }
  colors->Modified();
  GetDisc(ground)->Modified();
}
}
