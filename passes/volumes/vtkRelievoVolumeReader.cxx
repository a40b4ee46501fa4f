// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoVolumeTarget.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace relievo::f64;

namespace
{
glm::dvec3 Point(const glm::dmat4& matrix, const glm::dvec3& point)
{
  const glm::dvec4 moved = matrix * glm::dvec4(point, 1.0);
  return glm::dvec3(moved) / moved.w;
}

// A pixel's ray through a grid: position = Begin + t (End - Begin), from near to far plane.
struct Ray
{
  glm::dvec3 EyeBegin;
  glm::dvec3 EyeEnd;
  glm::dvec3 Begin;
  glm::dvec3 End;

  glm::dvec3 At(double t) const { return Begin + t * (End - Begin); }
  double GetDepth(double t) const { return -(EyeBegin.z + t * (EyeEnd.z - EyeBegin.z)); }

  // The t at which the ray enters the box of the corners.
  double Enter(const glm::dvec3 corners[2]) const
  {
    double entry = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along = End[axis] - Begin[axis];
      if (along != 0.0)
      {
        entry = std::max(entry,
          std::min(
            (corners[0][axis] - Begin[axis]) / along, (corners[1][axis] - Begin[axis]) / along));
      }
    }
    return entry;
  }
};
}

struct vtkRelievoVolumeReader::Pixels
{
  int Columns = 0;
  int Rows = 0;
  std::vector<std::array<std::vector<float>, vtkRelievoVolumeTarget::Textures>> Texels;
  std::vector<int> Nearest;       // volume in each pixel; -1: none
  std::vector<double> Depths;     // of the nearest
  std::vector<glm::dvec3> Places; // in the world
};

//------------------------------------------------------------------------------
void vtkRelievoDrawnVolume::Take(vtkVolume* volume, vtkDataSet* data)
{
  ++this->Draws;
  const glm::dmat4 dataToWorld = vtkRelievoToGlm(volume->GetMatrix());
  this->GridToData = glm::dmat4(1.0);
  double bounds[6];
  int points[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(points);
    this->GridToData = vtkRelievoToGlm(image->GetIndexToPhysicalMatrix());
    std::copy_n(image->GetExtent(), 6, bounds);
  }
  else
  {
    data->GetBounds(bounds);
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
    {
      grid->GetDimensions(points);
    }
  }
  this->Points = { points[0], points[1], points[2] };
  this->GridToWorld = dataToWorld * this->GridToData;
  this->Corners[0] = { bounds[0], bounds[2], bounds[4] };
  this->Corners[1] = { bounds[1], bounds[3], bounds[5] };
}

//------------------------------------------------------------------------------
vtkRelievoVolumeReader::vtkRelievoVolumeReader(vtkRelievoVolumeTarget& target,
  const std::vector<vtkRelievoDrawnVolume>& volumes, const vtkRelievoFrameCamera& view)
  : Volumes(volumes)
  , View(view)
  , Internal(new Pixels)
{
  Pixels& in = *this->Internal;
  in.Columns = view.Viewport[2];
  in.Rows = view.Viewport[3];
  const std::size_t count = static_cast<std::size_t>(in.Columns) * in.Rows;
  in.Nearest.assign(count, -1);
  in.Depths.assign(count, std::numeric_limits<double>::infinity());
  in.Places.assign(count, glm::dvec3(0.0));
  const glm::dmat4 ndcToView = glm::inverse(view.ViewToNDC);
  const glm::dmat4 viewToWorld = glm::inverse(view.WorldToView);
  // Where the camera is inside a volume, VTK starts rays at this depth.
  const double inside = view.Near +
    std::max(1e-3 * (view.Far - view.Near), 1e3 * std::numeric_limits<float>::epsilon());
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    const vtkRelievoDrawnVolume& volume = volumes[v];
    in.Texels.push_back(target.Read(static_cast<int>(v)));
    const glm::dmat4 viewToGrid = glm::inverse(volume.GridToWorld) * viewToWorld;
    for (std::size_t i = 0; volume.HasDepth && i < count; ++i)
    {
      const float* found = &in.Texels[v][1][4 * i];
      if (found[3] == 0.0f)
      {
        continue;
      }
      const glm::dvec2 ndc = relievoNdcFromPixel(
        glm::dvec2(static_cast<double>(i % in.Columns), static_cast<double>(i / in.Columns)),
        glm::dvec2(in.Columns, in.Rows));
      Ray ray;
      ray.EyeBegin = Point(ndcToView, glm::dvec3(ndc, -1.0));
      ray.EyeEnd = Point(ndcToView, glm::dvec3(ndc, 1.0));
      ray.Begin = Point(viewToGrid, ray.EyeBegin);
      ray.End = Point(viewToGrid, ray.EyeEnd);
      // The entry in double, if it is the one that VTK used.
      const float* start = &in.Texels[v][0][4 * i];
      const double perT =
        glm::length(glm::dmat3(volume.GridToData) * (ray.End - ray.Begin)); // data units
      const double perDepth = ray.GetDepth(1.0) - ray.GetDepth(0.0);
      double t = ray.Enter(volume.Corners);
      t = ray.GetDepth(t) < inside ? (inside - ray.GetDepth(0.0)) / perDepth : t;
      const double off = std::abs(ray.GetDepth(t) - start[0]) / perDepth * perT;
      t = off < 0.5 * start[1] ? t + found[0] * start[1] / perT
                               : (found[2] - ray.GetDepth(0.0)) / perDepth;
      if (ray.GetDepth(t) < in.Depths[i])
      {
        in.Nearest[i] = static_cast<int>(v);
        in.Depths[i] = ray.GetDepth(t);
        in.Places[i] = Point(volume.GridToWorld, ray.At(t));
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoVolumeReader::~vtkRelievoVolumeReader() = default;

//------------------------------------------------------------------------------
bool vtkRelievoVolumeReader::HasBricks() const
{
  const Pixels& in = *this->Internal;
  for (const auto& texels : in.Texels)
  {
    for (std::size_t i = 2; i < texels[0].size(); i += 4)
    {
      if (texels[0][i] != 0.0f)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeReader::Read(const std::string& name, vtkImageData* image)
{
  const Pixels& in = *this->Internal;
  const vtkRelievoLayer& layer = vtkRelievoLayerCatalogue::Find(name);
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layer.Type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(layer.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(in.Nearest.size()));
  array->Fill(layer.Background);
  for (std::size_t i = 0; i < in.Nearest.size(); ++i)
  {
    const auto pixel = static_cast<vtkIdType>(i);
    if (name == "volume_opacity")
    {
      double passes = 1.0;
      for (const auto& texels : in.Texels)
      {
        passes *= 1.0 - texels[0][4 * i + 3];
      }
      array->SetTuple1(pixel, 1.0 - passes);
    }
    else if (in.Nearest[i] >= 0)
    {
      const auto& texels = in.Texels[in.Nearest[i]];
      if (name == "volume_depth")
      {
        array->SetTuple1(pixel, in.Depths[i]);
      }
      else if (name == "volume_position")
      {
        array->SetTuple(pixel, &in.Places[i][0]);
      }
      else if (name == "volume_value")
      {
        array->SetTuple1(pixel, texels[1][4 * i + 1]);
      }
      else if (name == "volume_normal")
      {
        array->SetTuple(pixel, &texels[2][4 * i]);
      }
      else
      {
        array->SetTuple1(pixel, this->Volumes[in.Nearest[i]].Index);
      }
    }
  }
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(in.Columns, in.Rows, 1);
  }
  image->GetPointData()->AddArray(array);
}
