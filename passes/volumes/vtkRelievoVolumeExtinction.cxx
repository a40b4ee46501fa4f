// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeExtinction.h"

#include "vtkAbstractMapper.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoPropMTime.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace
{
constexpr int Entries = 4096; // of tables
// An opaque sample lets this share of the light pass in a unit distance.
constexpr double Opaque = 1e-7;

std::vector<vtkImageData*> FindImages(vtkDataObject* data, bool& others)
{
  std::vector<vtkImageData*> images;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    images.push_back(image);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      const std::vector<vtkImageData*> more = FindImages(leaf->GetCurrentDataObject(), others);
      images.insert(images.end(), more.begin(), more.end());
    }
  }
  else
  {
    others = others || data;
  }
  return images;
}

void AddDouble(std::vector<std::uint64_t>& state, double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  state.push_back(bits);
}

vtkDataArray* GetScalars(vtkVolumeMapper* mapper, vtkImageData* image, int& cells)
{
  return vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName(), cells);
}

// From indices of samples, which are points or the centres of cells, and their number.
glm::dmat4 GetIndexToData(vtkImageData* image, bool cells, int size[3])
{
  int extent[6];
  image->GetExtent(extent);
  glm::dmat4 toCorner(1.0);
  for (int i = 0; i < 3; ++i)
  {
    const int across = extent[2 * i + 1] - extent[2 * i];
    size[i] = std::max(1, cells ? across : across + 1);
    toCorner[3][i] = extent[2 * i] + (cells ? 0.5 : 0.0);
  }
  return vtkRelievoToGlm(image->GetIndexToPhysicalMatrix()) * toCorner;
}

// The reason why rays cannot follow the mapper's drawing, or "".
std::string FindWhyNot(vtkVolume* volume, vtkVolumeMapper* mapper)
{
  vtkVolumeProperty* property = volume->GetProperty();
  if (volume->IsA("vtkMultiVolume"))
  {
    return "it is a vtkMultiVolume; use a vtkVolume for each of its volumes";
  }
  if (!mapper)
  {
    return "its mapper is not a vtkVolumeMapper";
  }
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "its blend mode is not composite";
  }
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "its transfer function has two dimensions";
  }
  return std::string();
}
}

//------------------------------------------------------------------------------
vtkRelievoPlacedVolume::vtkRelievoPlacedVolume(vtkVolume* volume, vtkMatrix4x4* toWorld)
  : Volume(volume)
  , ToWorld(vtkRelievoToGlm(toWorld ? toWorld : volume->GetMatrix()))
{
}

//------------------------------------------------------------------------------
vtkRelievoVolumeExtinction::vtkRelievoVolumeExtinction() = default;
vtkRelievoVolumeExtinction::~vtkRelievoVolumeExtinction() = default;
vtkRelievoVolumeExtinction::vtkRelievoVolumeExtinction(const vtkRelievoVolumeExtinction&) = default;
vtkRelievoVolumeExtinction& vtkRelievoVolumeExtinction::operator=(
  const vtkRelievoVolumeExtinction&) = default;

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeExtinction::FindWhyNotPlaced(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (volume->IsA("vtkMultiVolume"))
  {
    return "it is a vtkMultiVolume; use a vtkVolume for each of its volumes";
  }
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  if (mapper->IsA("vtkFixedPointVolumeRayCastMapper") ||
    (smart && smart->GetLastUsedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode))
  {
    return "its mapper draws on the processor; use a vtkGPUVolumeRayCastMapper";
  }
  bool others = false;
  const bool any = !FindImages(mapper->GetDataObjectInput(), others).empty();
  return others || !any ? "its data are not a vtkImageData" : "";
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoVolumeExtinction::GetTextureToWorld(vtkVolumeMapper* mapper, vtkVolume* volume)
{
  glm::dmat4 textureToIndex(1.0);
  glm::dmat4 indexToData(1.0);
  if (auto* image = vtkImageData::SafeDownCast(mapper->GetDataObjectInput()))
  {
    int cells = 0;
    int size[3];
    GetScalars(mapper, image, cells);
    indexToData = GetIndexToData(image, cells != 0, size);
    for (int i = 0; i < 3; ++i)
    {
      textureToIndex[i][i] = size[i];
      textureToIndex[3][i] = -0.5;
    }
  }
  return vtkRelievoToGlm(volume->GetMatrix()) * indexToData * textureToIndex;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExtinction::AddState(
  const vtkRelievoPlacedVolume& placed, std::vector<std::uint64_t>& state)
{
  vtkVolume* volume = placed.Volume;
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  vtkVolumeProperty* property = volume->GetProperty();
  state.push_back(reinterpret_cast<std::uintptr_t>(volume));
  // Without colours and coefficients of light, which extinction does not depend on.
  state.push_back(property->GetScalarOpacity(0)->GetMTime());
  const bool gradients = property->HasGradientOpacity() && !property->GetDisableGradientOpacity();
  state.push_back(gradients ? property->GetGradientOpacity(0)->GetMTime() : 0);
  AddDouble(state, property->GetScalarOpacityUnitDistance(0));
  state.push_back(property->GetInterpolationType());
  state.push_back(property->GetIndependentComponents());
  state.push_back(property->GetTransferFunctionMode());
  std::for_each(&placed.ToWorld[0].x, &placed.ToWorld[0].x + 16,
    [&](double value) { AddDouble(state, value); });
  if (!mapper)
  {
    return;
  }
  vtkDataObject* data = mapper->GetDataObjectInput();
  state.push_back(reinterpret_cast<std::uintptr_t>(data));
  state.push_back(data ? vtkRelievoPropMTime::OfData(data) : 0);
  state.push_back(mapper->GetBlendMode());
  state.push_back(mapper->GetScalarMode());
  state.push_back(mapper->GetArrayAccessMode());
  state.push_back(mapper->GetArrayId());
  state.push_back(std::hash<std::string>()(mapper->GetArrayName() ? mapper->GetArrayName() : ""));
  state.push_back(mapper->GetCropping() ? 1 + mapper->GetCroppingRegionFlags() : 0);
  std::for_each(mapper->GetCroppingRegionPlanes(), mapper->GetCroppingRegionPlanes() + 6,
    [&](double value) { AddDouble(state, value); });
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      state.push_back(plane->GetMTime());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoVolumeExtinction> vtkRelievoVolumeExtinction::Collect(
  const vtkRelievoPlacedVolume& placed, std::string& why)
{
  vtkVolume* volume = placed.Volume;
  std::vector<vtkRelievoVolumeExtinction> fields;
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  why = FindWhyNot(volume, mapper);
  bool others = false;
  std::vector<vtkImageData*> images;
  if (why.empty())
  {
    images = FindImages(mapper->GetDataObjectInput(), others);
  }
  if (images.empty() && others)
  {
    why = "its data are not a vtkImageData";
  }
  vtkVolumeProperty* property = volume->GetProperty();
  for (vtkImageData* image : images)
  {
    vtkRelievoVolumeExtinction field;
    int cells = 0;
    field.Array = GetScalars(mapper, image, cells);
    if (!field.Array || field.Array->GetNumberOfTuples() == 0)
    {
      continue;
    }
    const int components = field.Array->GetNumberOfComponents();
    if (components > 1 && property->GetIndependentComponents())
    {
      why = "its components are independent; switch IndependentComponents off, or give it one";
      return {};
    }
    if (components == 3)
    {
      why = "it has three dependent components, which VTK does not draw";
      return {};
    }
    if (!field.Array->HasStandardMemoryLayout()) // threads read its memory
    {
      auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(field.Array->GetDataType()));
      copy->DeepCopy(field.Array);
      field.Array = copy;
    }
    field.Component = components - 1; // the last of two or four is the opacity's
    field.Nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;

    const glm::dmat4 indexToData = GetIndexToData(image, cells != 0, field.Size);
    for (int i = 0; i < 3; ++i)
    {
      field.Low[i] = cells ? -0.5 : 0.0;
      field.High[i] = field.Size[i] - 1.0 - field.Low[i];
    }
    if (field.Array->GetNumberOfTuples() <
      static_cast<vtkIdType>(field.Size[0]) * field.Size[1] * field.Size[2])
    {
      continue;
    }
    const glm::dmat4 indexToWorld = placed.ToWorld * indexToData;
    if (!(std::abs(glm::determinant(indexToWorld)) > 0.0))
    {
      continue;
    }
    field.WorldToIndex = glm::inverse(indexToWorld);
    field.IndexToData = glm::dmat3(indexToData);
    field.Axes = glm::dmat3(indexToWorld);
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 corner(i & 1 ? field.High[0] : field.Low[0],
        i & 2 ? field.High[1] : field.Low[1], i & 4 ? field.High[2] : field.Low[2]);
      field.Corners.emplace_back(indexToWorld * glm::dvec4(corner, 1.0));
    }

    if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
    {
      vtkCollectionSimpleIterator it;
      planes->InitTraversal(it);
      while (vtkPlane* plane = planes->GetNextPlane(it))
      {
        const double* n = plane->GetNormal();
        const double* o = plane->GetOrigin();
        field.Planes.emplace_back(n[0], n[1], n[2], -(n[0] * o[0] + n[1] * o[1] + n[2] * o[2]));
      }
    }
    if (mapper->GetCropping())
    {
      field.Cropped = mapper->GetCroppingRegionFlags();
      const double* planes = mapper->GetCroppingRegionPlanes();
      const glm::dmat4 dataToIndex = glm::inverse(indexToData);
      for (int i = 0; i < 6; ++i)
      {
        glm::dvec4 place(0.0, 0.0, 0.0, 1.0);
        place[i / 2] = planes[i];
        field.Crop[i] = (dataToIndex * place)[i / 2];
      }
    }

    double range[2];
    field.Array->GetFiniteRange(range, field.Component);
    if (components == 4 && field.Array->GetDataType() == VTK_UNSIGNED_CHAR)
    {
      range[0] = 0.0;
      range[1] = 255.0;
    }
    range[1] = range[1] > range[0] ? range[1] : range[0] + 1.0;
    std::vector<float> opacities(Entries);
    property->GetScalarOpacity(0)->GetTable(range[0], range[1], Entries, opacities.data());
    const double unit = std::max(1e-300, property->GetScalarOpacityUnitDistance(0));
    field.Extinction.resize(Entries);
    std::transform(
      opacities.begin(), opacities.end(), field.Extinction.begin(), [&](float opacity) {
        return static_cast<float>(-std::log1p(-std::min<double>(opacity, 1.0 - Opaque)) / unit);
      });
    if (*std::max_element(field.Extinction.begin(), field.Extinction.end()) <= 0.f)
    {
      continue;
    }
    field.First = static_cast<float>(range[0]);
    field.PerScalar = static_cast<float>((Entries - 1) / (range[1] - range[0]));
    if (property->HasGradientOpacity() && !property->GetDisableGradientOpacity())
    {
      field.GradientOpacity.resize(Entries);
      property->GetGradientOpacity(0)->GetTable(
        0.0, 0.25 * (range[1] - range[0]), Entries, field.GradientOpacity.data());
      const glm::dvec3 spacing(
        image->GetSpacing()[0], image->GetSpacing()[1], image->GetSpacing()[2]);
      const double mean = (spacing.x + spacing.y + spacing.z) / 3.0;
      field.Weights =
        glm::vec3(mean / (2.0 * spacing) * (4.0 * (Entries - 1) / (range[1] - range[0])));
    }
    fields.push_back(field);
  }
  return fields;
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeExtinction::GetSpacing() const
{
  double least = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double length = this->Size[i] > 1 ? glm::length(this->Axes[i]) : 0.0;
    least = least > 0.0 && length > 0.0 ? std::min(least, length) : std::max(least, length);
  }
  return least > 0.0 ? least : 1.0;
}

//------------------------------------------------------------------------------
template <typename T>
inline float vtkRelievoVolumeExtinction::GetScalar(const T* values, const glm::vec3& place) const
{
  int low[3];
  int high[3];
  float part[3];
  for (int i = 0; i < 3; ++i)
  {
    const float last = static_cast<float>(this->Size[i] - 1);
    float at = std::min(std::max(place[i], 0.f), last);
    at = this->Nearest ? std::floor(at + 0.5f) : at;
    low[i] = static_cast<int>(at);
    high[i] = std::min(low[i] + 1, this->Size[i] - 1);
    part[i] = at - static_cast<float>(low[i]);
  }
  const std::ptrdiff_t across = this->Array->GetNumberOfComponents();
  const std::ptrdiff_t row = across * this->Size[0];
  const std::ptrdiff_t slice = row * this->Size[1];
  const T* z0 = values + slice * low[2];
  const T* z1 = values + slice * high[2];
  const std::ptrdiff_t y0 = row * low[1];
  const std::ptrdiff_t y1 = row * high[1];
  const std::ptrdiff_t x0 = across * low[0];
  const std::ptrdiff_t x1 = across * high[0];
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const auto line = [&](const T* from) {
    return mix(static_cast<float>(from[x0]), static_cast<float>(from[x1]), part[0]);
  };
  return mix(mix(line(z0 + y0), line(z0 + y1), part[1]), mix(line(z1 + y0), line(z1 + y1), part[1]),
    part[2]);
}

//------------------------------------------------------------------------------
template <typename T>
inline float vtkRelievoVolumeExtinction::GetExtinction(
  const T* values, const glm::vec3& place) const
{
  const auto look = [](const std::vector<float>& table, float entry) {
    const int before = std::min(static_cast<int>(entry), Entries - 2);
    return table[before] +
      std::min(entry - static_cast<float>(before), 1.f) * (table[before + 1] - table[before]);
  };
  const float entry = (this->GetScalar(values, place) - this->First) * this->PerScalar;
  if (std::isnan(entry))
  {
    return 0.f;
  }
  float extinction = look(this->Extinction, std::min(std::max(entry, 0.f), Entries - 1.f));
  if (extinction > 0.f && !this->GradientOpacity.empty())
  {
    glm::vec3 gradient;
    for (int i = 0; i < 3; ++i)
    {
      glm::vec3 step(0.f);
      step[i] = 1.f;
      gradient[i] = this->Weights[i] *
        (this->GetScalar(values, place + step) - this->GetScalar(values, place - step));
    }
    const float length = glm::length(gradient);
    extinction *=
      std::isnan(length) ? 0.f : look(this->GradientOpacity, std::min(length, Entries - 1.f));
  }
  return extinction;
}

//------------------------------------------------------------------------------
template <typename T>
void vtkRelievoVolumeExtinction::March(const T* values, const glm::dvec3& from,
  const glm::dvec3& step, double first, double last, int samples, std::vector<float>& depths) const
{
  const float length = static_cast<float>(glm::length(this->IndexToData * step));
  const int pieces = static_cast<int>(depths.size());
  const glm::vec3 start(from);
  const glm::vec3 along(step);
  for (int k = std::max(0, static_cast<int>(std::floor(first))); k < pieces && k < last; ++k)
  {
    const double begin = std::max<double>(first, k);
    const double end = std::min<double>(last, k + 1);
    float sum = 0.f;
    for (int i = 0; i < samples; ++i)
    {
      const float t = static_cast<float>(begin + (end - begin) * (i + 0.5) / samples);
      const glm::vec3 place = start + t * along;
      bool there = true;
      if (this->Cropped >= 0)
      {
        int region = 0;
        for (int axis = 0, stride = 1; axis < 3; ++axis, stride *= 3)
        {
          const double at = place[axis];
          region += stride *
            (at <= this->Crop[2 * axis]          ? 0
                : at <= this->Crop[2 * axis + 1] ? 1
                                                 : 2);
        }
        there = (this->Cropped >> region & 1) != 0;
      }
      sum += there ? this->GetExtinction(values, place) : 0.f;
    }
    depths[k] += sum * length * static_cast<float>((end - begin) / samples);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExtinction::Clip(
  const glm::dvec3& from, const glm::dvec3& step, double& first, double& last) const
{
  const auto cut = [&](double at, double change) { // to where at + t * change >= 0
    if (change == 0.0)
    {
      last = at < 0.0 ? first - 1.0 : last;
      return;
    }
    const double t = -at / change;
    (change > 0.0 ? first : last) = change > 0.0 ? std::max(first, t) : std::min(last, t);
  };
  const glm::dvec3 start(this->WorldToIndex * glm::dvec4(from, 1.0));
  const glm::dvec3 along(glm::dmat3(this->WorldToIndex) * step);
  for (int i = 0; i < 3; ++i)
  {
    cut(start[i] - this->Low[i], along[i]);
    cut(this->High[i] - start[i], -along[i]);
  }
  for (const glm::dvec4& plane : this->Planes)
  {
    cut(glm::dot(plane, glm::dvec4(from, 1.0)), glm::dot(glm::dvec3(plane), step));
  }
  return first < last;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExtinction::AddDepths(
  const glm::dvec3& from, const glm::dvec3& step, int samples, std::vector<float>& depths) const
{
  double first = 0.0;
  double last = static_cast<double>(depths.size());
  if (!this->Clip(from, step, first, last))
  {
    return;
  }
  const glm::dvec3 start(this->WorldToIndex * glm::dvec4(from, 1.0));
  const glm::dvec3 along(glm::dmat3(this->WorldToIndex) * step);
  switch (this->Array->GetDataType())
  {
    vtkTemplateMacro(
      this->March(static_cast<const VTK_TT*>(this->Array->GetVoidPointer(0)) + this->Component,
        start, along, first, last, samples, depths));
    default:
      break;
  }
}
