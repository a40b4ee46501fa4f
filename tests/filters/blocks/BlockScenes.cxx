// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockScenes.h"

#include "Check.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoSmoothBlocks.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

namespace relievoTest
{
//------------------------------------------------------------------------------
vtkPolyData* Run(vtkRelievoSmoothBlocks* filter, vtkImageData* image)
{
  filter->SetInputData(image);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeBlocks(
  const std::array<int, 3>& size, const LabelOf& label, int type, bool onPoints)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int more = onPoints ? 0 : 1;
  image->SetDimensions(size[0] + more, size[1] + more, size[2] + more);
  auto labels = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  labels->SetName("labels");
  const vtkIdType count = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
  labels->SetNumberOfTuples(count);
  switch (type)
  {
    vtkTemplateMacro({
      auto* values = static_cast<VTK_TT*>(labels->GetVoidPointer(0));
      for (int k = 0; k < size[2]; ++k)
      {
        for (int j = 0; j < size[1]; ++j)
        {
          for (int i = 0; i < size[0]; ++i)
          {
            *values++ = static_cast<VTK_TT>(label(i, j, k));
          }
        }
      }
    });
  }
  vtkDataSetAttributes* data = image->GetCellData();
  if (onPoints)
  {
    data = image->GetPointData();
  }
  data->SetScalars(labels);
  return image;
}

//------------------------------------------------------------------------------
LabelOf BallOf(double radius, const std::array<double, 3>& center)
{
  return [radius, center](int i, int j, int k) {
    const double x = i + 0.5 - center[0];
    const double y = j + 0.5 - center[1];
    const double z = k + 0.5 - center[2];
    return vtkTypeInt64(x * x + y * y + z * z <= radius * radius);
  };
}

//------------------------------------------------------------------------------
LabelOf AnyOf(unsigned int seed, int count)
{
  return [seed, count](int i, int j, int k) {
    unsigned int word = seed + 0x9e3779b9u * static_cast<unsigned int>(i);
    for (const int next : { j, k, 77 })
    {
      word = (word ^ word >> 15) * 0x2c1b3c6du + static_cast<unsigned int>(next) * 0x85ebca6bu;
      word = (word ^ word >> 12) * 0x297a2d39u;
    }
    return vtkTypeInt64((word >> 8) % static_cast<unsigned int>(count));
  };
}

namespace
{
Place PlaceOf(vtkPolyData* surface, vtkIdType point)
{
  Place place;
  surface->GetPoint(point, place.data());
  return place;
}

template <typename Each>
void ForEachPolygon(vtkPolyData* surface, Each&& each)
{
  vtkNew<vtkIdList> points;
  vtkCellArray* polygons = surface->GetPolys();
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, points);
    each(i, points.Get());
  }
}

Edge EdgeOf(const Place& a, const Place& b)
{
  return a < b ? Edge{ a, b } : Edge{ b, a };
}
}

//------------------------------------------------------------------------------
void ForEachTriangle(
  vtkPolyData* surface, const std::function<void(vtkIdType, vtkIdList*, const Place*)>& each)
{
  ForEachPolygon(surface, [&](vtkIdType triangle, vtkIdList* points) {
    Place corners[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = PlaceOf(surface, points->GetId(i));
    }
    each(triangle, points, corners);
  });
}

//------------------------------------------------------------------------------
void AreaOf(const Place* corners, double area[3])
{
  double sides[2][3];
  vtkMath::Subtract(corners[1].data(), corners[0].data(), sides[0]);
  vtkMath::Subtract(corners[2].data(), corners[0].data(), sides[1]);
  vtkMath::Cross(sides[0], sides[1], area);
}

//------------------------------------------------------------------------------
std::map<Edge, int> EdgeUses(vtkPolyData* surface)
{
  std::map<Edge, int> uses;
  ForEachPolygon(surface, [&](vtkIdType, vtkIdList* points) {
    const vtkIdType count = points->GetNumberOfIds();
    for (vtkIdType i = 0; i < count; ++i)
    {
      ++uses[EdgeOf(
        PlaceOf(surface, points->GetId(i)), PlaceOf(surface, points->GetId((i + 1) % count)))];
    }
  });
  return uses;
}

//------------------------------------------------------------------------------
int UnlistedEdges(vtkPolyData* surface, vtkPolyData* seams)
{
  std::map<Edge, int> uses = EdgeUses(surface);
  int mismatches = 0;
  vtkNew<vtkIdList> points;
  vtkDataArray* counts = seams->GetCellData()->GetArray("uses");
  for (vtkIdType i = 0; i < seams->GetLines()->GetNumberOfCells(); ++i)
  {
    seams->GetLines()->GetCellAtId(i, points);
    const Edge edge = EdgeOf(PlaceOf(seams, points->GetId(0)), PlaceOf(seams, points->GetId(1)));
    const auto found = uses.find(edge);
    const bool right = found != uses.end() && found->second != 2 &&
      found->second == static_cast<int>(counts->GetComponent(i, 0));
    mismatches += !right;
    if (right)
    {
      found->second = 2;
    }
  }
  for (const auto& edge : uses)
  {
    mismatches += edge.second != 2;
  }
  return mismatches;
}

//------------------------------------------------------------------------------
double SmallestArea(vtkPolyData* surface)
{
  double smallest = std::numeric_limits<double>::infinity();
  ForEachTriangle(surface, [&](vtkIdType, vtkIdList*, const Place* corners) {
    smallest = std::min(
      smallest, vtkTriangle::TriangleArea(corners[0].data(), corners[1].data(), corners[2].data()));
  });
  return smallest;
}

//------------------------------------------------------------------------------
double VolumeOf(vtkPolyData* surface)
{
  double volume = 0.;
  ForEachPolygon(surface, [&](vtkIdType, vtkIdList* points) {
    const Place a = PlaceOf(surface, points->GetId(0));
    for (vtkIdType i = 1; i + 1 < points->GetNumberOfIds(); ++i)
    {
      const Place b = PlaceOf(surface, points->GetId(i));
      const Place c = PlaceOf(surface, points->GetId(i + 1));
      volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
        a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  });
  return volume / 6.;
}

//------------------------------------------------------------------------------
vtkIdType EulerNumber(vtkPolyData* surface)
{
  std::set<Place> places;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    places.insert(PlaceOf(surface, i));
  }
  return static_cast<vtkIdType>(places.size()) - static_cast<vtkIdType>(EdgeUses(surface).size()) +
    surface->GetNumberOfPolys();
}
}
