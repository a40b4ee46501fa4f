// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoVolumeTarget.h"
#include "vtkRelievoVolumesStage.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace relievo::f64;

namespace
{
constexpr int Around = 3; // steps in which the refined place is looked for

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
  std::vector<float> Values;      // of the data
};

//------------------------------------------------------------------------------
void vtkRelievoDrawnVolume::Take(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, int longest)
{
  ++this->Draws;
  this->IsExtreme = mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND;
  vtkDataSet* data = mapper->GetDataSetInput();
  int cells = 0;
  vtkDataArray* values = vtkAbstractMapper::GetScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
  this->IsWhole = values && values->GetDataType() != VTK_FLOAT &&
    values->GetDataType() != VTK_DOUBLE &&
    volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  this->HasMarch = this->Draws == 1 && this->March.Take(mapper, volume, longest);
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
  std::vector<vtkRelievoDrawnVolume>& volumes, const vtkRelievoFrameCamera& view, int rule,
  double threshold, bool refines)
  : Volumes(volumes)
  , View(view)
  , Rule(rule)
  , Threshold(threshold)
  , Refines(refines)
  , Internal(new Pixels)
{
  Pixels& in = *this->Internal;
  in.Columns = view.Viewport[2];
  in.Rows = view.Viewport[3];
  for (int i = 0; i < static_cast<int>(volumes.size()); ++i)
  {
    in.Texels.push_back(target.Read(i));
  }
}

//------------------------------------------------------------------------------
// The volume's places in double, in pixels where they are the nearest.
void vtkRelievoVolumeReader::Find(int index)
{
  Pixels& in = *this->Internal;
  const vtkRelievoFrameCamera& view = this->View;
  vtkRelievoDrawnVolume& volume = this->Volumes[index];
  const auto& texels = in.Texels[index];
  const glm::dmat4 ndcToView = glm::inverse(view.ViewToNDC);
  const glm::dmat4 viewToGrid = glm::inverse(volume.GridToWorld) * glm::inverse(view.WorldToView);
  // Where the camera is inside a volume, VTK starts rays at this depth: it moves the near plane by
  // a thousandth of the range, as data units (vtkOpenGLGPUVolumeRayCastMapper's
  // RenderVolumeGeometry).
  constexpr double Epsilon = std::numeric_limits<float>::epsilon();
  const glm::dmat3 dataToWorld =
    glm::dmat3(volume.GridToWorld) * glm::inverse(glm::dmat3(volume.GridToData));
  const glm::dvec3 ahead(view.WorldToView[0][2], view.WorldToView[1][2], view.WorldToView[2][2]);
  const double moved = std::max(1e-3 * (view.Far - view.Near), 1e3 * Epsilon);
  const double inside = view.Near + moved * glm::length(ahead * dataToWorld);
  // VTK's errors of an entry, in data units and in depth.
  double inData = 0.0;
  double inDepth = 0.0;
  for (const glm::dvec3& corner : volume.Corners)
  {
    inData = std::max(inData, 8.0 * Epsilon * glm::length(Point(volume.GridToData, corner)));
    inDepth = std::max(inDepth, 8.0 * Epsilon * glm::length(Point(volume.GridToWorld, corner)));
  }
  bool refines = this->Refines && volume.HasMarch && volume.March.IsUnchanged();
  const auto step =
    std::find_if(texels[1].begin(), texels[1].end(), [](float x) { return x > 0.0f; });
  if (refines && step != texels[1].end())
  {
    const std::size_t pixel = static_cast<std::size_t>(step - texels[1].begin()) / 4;
    volume.March.SetStep(texels[0][4 * pixel + 1]);
  }
  const auto findPixel = [&](vtkIdType i) {
    const float* start = &texels[0][4 * i];
    const float* found = &texels[1][4 * i];
    if (found[3] == 0.0f)
    {
      return;
    }
    const glm::dvec2 ndc = relievoNdcFromPixel(
      glm::dvec2(static_cast<double>(i % in.Columns), static_cast<double>(i / in.Columns)),
      glm::dvec2(in.Columns, in.Rows));
    Ray ray;
    ray.EyeBegin = Point(ndcToView, glm::dvec3(ndc, -1.0));
    ray.EyeEnd = Point(ndcToView, glm::dvec3(ndc, 1.0));
    ray.Begin = Point(viewToGrid, ray.EyeBegin);
    ray.End = Point(viewToGrid, ray.EyeEnd);
    const double perT =
      glm::length(glm::dmat3(volume.GridToData) * (ray.End - ray.Begin)); // data units
    const double perDepth = ray.GetDepth(1.0) - ray.GetDepth(0.0);
    // The entry in double, if it is the one that VTK used.
    double t = ray.Enter(volume.Corners);
    const bool isInside = ray.GetDepth(t) < inside;
    t = isInside ? (inside - ray.GetDepth(0.0)) / perDepth : t;
    const double off = std::abs(ray.GetDepth(t) - start[0]) / perDepth * perT;
    // On the box's faces, OpenGL also rounds the corners to a part of a pixel.
    const double rounding = inData + inDepth / perDepth * perT + (isInside ? 0.0 : 0.5 * start[1]);
    float value = volume.IsWhole ? std::round(found[1]) : found[1];
    if (off <= rounding)
    {
      const double stepT = start[1] / perT;
      double steps = found[0];
      if (refines)
      {
        const int near = static_cast<int>(std::ceil(steps));
        const double refined =
          volume.March.FindStep(ray.At(t) - volume.Corners[0], stepT * (ray.End - ray.Begin),
            this->Rule, this->Threshold, std::max(1, near - Around), near + Around);
        steps = std::isnan(refined) ? steps : refined;
        // Between samples of other values, such as labels, only a sample has a value.
        const double valued = volume.March.IsLinear() ? steps : std::ceil(steps);
        value =
          static_cast<float>(volume.March.GetValue(ray.At(t + valued * stepT) - volume.Corners[0]));
      }
      t += steps * stepT;
    }
    else
    {
      t = (found[2] - ray.GetDepth(0.0)) / perDepth;
    }
    if (ray.GetDepth(t) < in.Depths[i])
    {
      in.Nearest[i] = index;
      in.Depths[i] = ray.GetDepth(t);
      in.Places[i] = Point(volume.GridToWorld, ray.At(t));
      in.Values[i] = value;
    }
  };
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(in.Nearest.size()), [&findPixel](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        findPixel(i);
      }
    });
}

//------------------------------------------------------------------------------
vtkRelievoVolumeReader::~vtkRelievoVolumeReader() = default;

//------------------------------------------------------------------------------
bool vtkRelievoVolumeReader::HasLostBricks() const
{
  for (std::size_t volume = 0; volume < this->Volumes.size(); ++volume)
  {
    const std::vector<float>& texels = this->Internal->Texels[volume][0];
    const bool loses =
      this->Rule != vtkRelievoVolumesStage::FIRST || this->Volumes[volume].IsExtreme;
    for (std::size_t i = 2; loses && i < texels.size(); i += 4)
    {
      if (texels[i] != 0.0f)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeReader::FindAll()
{
  Pixels& in = *this->Internal;
  const std::size_t count = static_cast<std::size_t>(in.Columns) * in.Rows;
  if (!in.Nearest.empty())
  {
    return;
  }
  in.Nearest.assign(count, -1);
  in.Depths.assign(count, std::numeric_limits<double>::infinity());
  in.Places.assign(count, glm::dvec3(0.0));
  in.Values.assign(count, 0.0f);
  for (int i = 0; i < static_cast<int>(this->Volumes.size()); ++i)
  {
    if (this->Volumes[i].HasDepth)
    {
      this->Find(i);
    }
  }
}

//------------------------------------------------------------------------------
// Rays through volumes end at the surface: where a volume has a place, it is the nearer one.
void vtkRelievoVolumeReader::Amend(const std::string& name, vtkImageData* image)
{
  Pixels& in = *this->Internal;
  this->FindAll();
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  for (std::size_t i = 0; i < in.Nearest.size(); ++i)
  {
    if (in.Nearest[i] < 0)
    {
      continue;
    }
    const auto pixel = static_cast<vtkIdType>(i);
    if (name == "position")
    {
      array->SetTuple(pixel, &in.Places[i][0]);
    }
    else
    {
      array->SetTuple1(pixel,
        name == "depth" ? in.Depths[i] : glm::length(Point(this->View.WorldToView, in.Places[i])));
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeReader::Read(const std::string& name, vtkImageData* image)
{
  Pixels& in = *this->Internal;
  const std::size_t count = static_cast<std::size_t>(in.Columns) * in.Rows;
  if (name != "volume_opacity")
  {
    this->FindAll();
  }
  const vtkRelievoLayer& layer = vtkRelievoLayerCatalogue::Find(name);
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layer.Type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(layer.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  array->Fill(layer.Background);
  for (std::size_t i = 0; i < count; ++i)
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
        array->SetTuple1(pixel, in.Values[i]);
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
