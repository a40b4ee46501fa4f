// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeExtinction.h"

#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkRelievoPlacedVolume.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Exactness = 1e-6; // of transmittances by GetDepth
constexpr int MostHalvings = 7;

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
    return "its transfer function has two dimensions, whose opacities VTK does not relate to a "
           "length; use SetScalarOpacity and SetGradientOpacity";
  }
  auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  if (gpu && gpu->GetMaskInput() &&
    gpu->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType)
  {
    return "its mask is a label map, whose labels have opacities of their own; use a binary mask, "
           "or a volume for each label";
  }
  return std::string();
}

// Of the values' type, as vtkImageMagnitude makes them.
vtkSmartPointer<vtkDataArray> MakeMagnitudes(vtkDataArray* vectors)
{
  auto magnitudes = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(vectors->GetDataType()));
  magnitudes->SetNumberOfTuples(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double squares = 0.0;
    for (int component = 0; component < vectors->GetNumberOfComponents(); ++component)
    {
      const double value = vectors->GetComponent(i, component);
      squares += value * value;
    }
    magnitudes->SetComponent(i, 0, std::sqrt(squares));
  }
  return magnitudes;
}
}

//------------------------------------------------------------------------------
vtkRelievoVolumeExtinction::vtkRelievoVolumeExtinction() = default;
vtkRelievoVolumeExtinction::~vtkRelievoVolumeExtinction() = default;
vtkRelievoVolumeExtinction::vtkRelievoVolumeExtinction(const vtkRelievoVolumeExtinction&) = default;
vtkRelievoVolumeExtinction& vtkRelievoVolumeExtinction::operator=(
  const vtkRelievoVolumeExtinction&) = default;

//------------------------------------------------------------------------------
std::vector<vtkRelievoVolumeExtinction> vtkRelievoVolumeExtinction::Collect(
  const vtkRelievoPlacedVolume& placed, std::string& why, bool colored)
{
  vtkVolume* volume = placed.Volume;
  std::vector<vtkRelievoVolumeExtinction> fields;
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  why = FindWhyNot(volume, mapper);
  bool others = false;
  std::vector<vtkImageData*> images;
  if (why.empty())
  {
    images = vtkRelievoVolumeImages::Find(mapper->GetDataObjectInput(), others);
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
    field.Array = vtkRelievoVolumeImages::GetScalars(mapper, image, cells);
    if (!field.Array || field.Array->GetNumberOfTuples() == 0)
    {
      continue;
    }
    why = vtkRelievoVolumeImages::FindWhyNotDrawn(volume, image, field.Array, cells != 0);
    if (!why.empty())
    {
      return {};
    }
    const int part = vtkRelievoVolumeImages::GetVectorPart(mapper, field.Array);
    if (part == vtkRelievoVolumeImages::Magnitude)
    {
      if (cells)
      {
        why = "its mapper draws the magnitude of cells' vectors, which VTK smooths; use an array "
              "of magnitudes";
        return {};
      }
      field.Array = MakeMagnitudes(field.Array);
    }
    const int components = field.Array->GetNumberOfComponents();
    const bool independent = components > 1 && property->GetIndependentComponents();
    if ((components == 3 && !independent) || components > VTK_MAX_VRCOMP)
    {
      why = "it has " + std::to_string(components) + (independent ? "" : " dependent") +
        " components, which VTK does not draw";
      return {};
    }
    if (!field.Array->HasStandardMemoryLayout()) // threads read its memory
    {
      auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(field.Array->GetDataType()));
      copy->DeepCopy(field.Array);
      field.Array = copy;
    }
    field.Nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;

    const glm::dmat4 indexToData =
      vtkRelievoVolumeImages::GetIndexToData(image, cells != 0, field.Size);
    for (int i = 0; i < 3; ++i)
    {
      field.Low[i] = cells ? -0.5 : 0.0;
      field.High[i] = field.Size[i] - 1.0 - field.Low[i];
    }
    if (field.Array->GetNumberOfTuples() <
        static_cast<vtkIdType>(field.Size[0]) * field.Size[1] * field.Size[2] ||
      !field.SetPlace(placed.ToWorld, indexToData))
    {
      continue;
    }
    why = field.Cuts.Set(mapper, image, cells != 0, field.Size, indexToData);
    if (!why.empty())
    {
      return {};
    }
    const double stretch = vtkRelievoVolumeImages::IsDrawnOnProcessor(mapper)
      ? 1.0
      : vtkRelievoVolumeImages::GetStretch(field.Array);
    for (int i = std::max(part, 0); i < (part >= 0 ? part + 1 : independent ? components : 1); ++i)
    {
      // The last of two or four dependent components is the opacity's. One component of vectors has
      // the first one's functions.
      const int function = part >= 0 ? 0 : i;
      vtkRelievoVolumeChannel channel(property, image, field.Array,
        independent || part >= 0 ? i : components - 1, i, function, stretch);
      const bool seen = *std::max_element(channel.Extinction.begin(), channel.Extinction.end()) > 0;
      // VTK weights components only if there are several.
      channel.Weight = independent && part < 0 ? channel.Weight : 1.f;
      if (seen && channel.Weight > 0.f)
      {
        if (colored)
        {
          channel.AddTints(property, field.Array, function);
        }
        field.Channels.push_back(channel);
      }
    }
    if (!field.Channels.empty())
    {
      fields.push_back(field);
    }
  }
  return fields;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExtinction::SetPlace(const glm::dmat4& toWorld, const glm::dmat4& indexToData)
{
  const glm::dmat4 indexToWorld = toWorld * indexToData;
  if (!(std::abs(glm::determinant(indexToWorld)) > 0.0))
  {
    return false;
  }
  this->WorldToIndex = glm::inverse(indexToWorld);
  this->IndexToData = glm::dmat3(indexToData);
  this->Axes = glm::dmat3(indexToWorld);
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 corner(i & 1 ? this->High[0] : this->Low[0],
      i & 2 ? this->High[1] : this->Low[1], i & 4 ? this->High[2] : this->Low[2]);
    this->Corners.emplace_back(indexToWorld * glm::dvec4(corner, 1.0));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExtinction::HasTints() const
{
  return std::any_of(this->Channels.begin(), this->Channels.end(),
    [](const vtkRelievoVolumeChannel& channel) { return !channel.Tints.empty(); });
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
template <typename T, typename Real>
inline Real vtkRelievoVolumeExtinction::GetScalar(
  const T* values, int component, const glm::vec<3, Real>& place) const
{
  int low[3];
  int high[3];
  Real part[3];
  for (int i = 0; i < 3; ++i)
  {
    const Real last = static_cast<Real>(this->Size[i] - 1);
    Real at = std::min(std::max(place[i], Real(0)), last);
    at = this->Nearest ? std::floor(at + Real(0.5)) : at;
    low[i] = static_cast<int>(at);
    high[i] = std::min(low[i] + 1, this->Size[i] - 1);
    part[i] = at - static_cast<Real>(low[i]);
  }
  const std::ptrdiff_t across = this->Array->GetNumberOfComponents();
  const std::ptrdiff_t row = across * this->Size[0];
  const std::ptrdiff_t slice = row * this->Size[1];
  const T* z0 = values + component + slice * low[2];
  const T* z1 = values + component + slice * high[2];
  const std::ptrdiff_t y0 = row * low[1];
  const std::ptrdiff_t y1 = row * high[1];
  const std::ptrdiff_t x0 = across * low[0];
  const std::ptrdiff_t x1 = across * high[0];
  const auto mix = [](Real a, Real b, Real t) { return a + t * (b - a); };
  const auto line = [&](const T* from) {
    return mix(static_cast<Real>(from[x0]), static_cast<Real>(from[x1]), part[0]);
  };
  return mix(mix(line(z0 + y0), line(z0 + y1), part[1]), mix(line(z1 + y0), line(z1 + y1), part[1]),
    part[2]);
}

//------------------------------------------------------------------------------
template <typename T>
inline float vtkRelievoVolumeExtinction::GetExtinction(
  const vtkRelievoVolumeChannel& channel, const T* values, const glm::vec3& place) const
{
  const float entry =
    (this->GetScalar(values, channel.Component, place) - channel.First) * channel.PerScalar;
  if (std::isnan(entry))
  {
    return 0.f;
  }
  float extinction = vtkRelievoVolumeChannel::Look(channel.Extinction, entry);
  if (extinction > 0.f && !channel.GradientOpacity.empty())
  {
    glm::vec3 gradient;
    for (int i = 0; i < 3; ++i)
    {
      glm::vec3 step(0.f);
      step[i] = 1.f;
      gradient[i] = channel.Weights[i] *
        (this->GetScalar(values, channel.Component, place + step) -
          this->GetScalar(values, channel.Component, place - step));
    }
    const float length = glm::length(gradient);
    extinction *= std::isnan(length)
      ? 0.f
      : vtkRelievoVolumeChannel::Look(channel.GradientOpacity,
          static_cast<float>(length / channel.Steepest) * (vtkRelievoVolumeChannel::Entries - 1.f));
  }
  return extinction;
}

//------------------------------------------------------------------------------
// The tint and, last, the extinction. VTK weighs independent components' opacities by themselves.
template <typename T>
inline glm::vec4 vtkRelievoVolumeExtinction::GetAll(
  const T* values, const glm::vec3& place, bool tinted) const
{
  glm::vec4 sum(0.f);
  float whole = 0.f;
  for (const vtkRelievoVolumeChannel& channel : this->Channels)
  {
    const float extinction = this->GetExtinction(channel, values, place);
    if (extinction <= 0.f)
    {
      continue;
    }
    const float square = extinction * extinction;
    whole += extinction * channel.Weight;
    sum.w += square;
    if (tinted && !channel.Tints.empty())
    {
      const float entry =
        (this->GetScalar(values, channel.TintBy, place) - channel.FirstTint) * channel.PerTint;
      const glm::vec3 tint =
        vtkRelievoVolumeChannel::Look(channel.Tints, std::isnan(entry) ? 0.f : entry);
      sum += glm::vec4(square * tint, 0.f);
    }
  }
  return whole > 0.f ? sum / whole : sum;
}

//------------------------------------------------------------------------------
template <typename T>
double vtkRelievoVolumeExtinction::GetExact(const T* values, const glm::dvec3& place) const
{
  double squares = 0.0;
  double whole = 0.0;
  for (const vtkRelievoVolumeChannel& channel : this->Channels)
  {
    const double* range = channel.Range;
    const double scalar = channel.Stretch * this->GetScalar(values, channel.Component, place);
    if (std::isnan(scalar))
    {
      continue;
    }
    double extinction = vtkRelievoVolumeChannel::GetExtinction(
      channel.Opacity.Get(std::min(std::max(scalar, range[0]), range[1])), channel.Unit);
    if (channel.Gradient)
    {
      glm::dvec3 gradient;
      for (int i = 0; i < 3; ++i)
      {
        glm::dvec3 step(0.0);
        step[i] = 1.0;
        gradient[i] = static_cast<double>(channel.Weights[i]) *
          (this->GetScalar(values, channel.Component, place + step) -
            this->GetScalar(values, channel.Component, place - step));
      }
      const double length = glm::length(gradient);
      extinction *=
        std::isnan(length) ? 0.0 : channel.Gradient.Get(std::min(length, channel.Steepest));
    }
    squares += extinction * extinction;
    whole += extinction * channel.Weight;
  }
  return whole > 0.0 ? squares / whole : 0.0;
}

//------------------------------------------------------------------------------
template <typename T>
void vtkRelievoVolumeExtinction::March(const T* values, const glm::dvec3& from,
  const glm::dvec3& step, double first, double last, int samples, std::vector<float>& depths,
  std::vector<glm::vec3>& tints) const
{
  const float length = static_cast<float>(glm::length(this->IndexToData * step));
  const int pieces = static_cast<int>(depths.size());
  const glm::vec3 start(from);
  const glm::vec3 along(step);
  const bool cut = this->Cuts.CutsInside();
  const bool tinted = !tints.empty();
  const bool one = this->Channels.size() == 1 && this->Channels[0].Weight == 1.f && !tinted;
  for (int k = std::max(0, static_cast<int>(std::floor(first))); k < pieces && k < last; ++k)
  {
    const double begin = std::max<double>(first, k);
    const double end = std::min<double>(last, k + 1);
    const float width = length * static_cast<float>((end - begin) / samples);
    for (int i = 0; i < samples; ++i)
    {
      const float t = static_cast<float>(begin + (end - begin) * (i + 0.5) / samples);
      const glm::vec3 place = start + t * along;
      if (cut && !this->Cuts.IsThere(place))
      {
        continue;
      }
      if (one)
      {
        depths[k] += width * this->GetExtinction(this->Channels[0], values, place);
        continue;
      }
      const glm::vec4 all = width * this->GetAll(values, place, tinted);
      depths[k] += all.w;
      if (tinted)
      {
        tints[k] += glm::vec3(all);
      }
    }
  }
}

//------------------------------------------------------------------------------
// The places of a ray between which the extinction is smooth, but for the opacity function.
std::vector<double> vtkRelievoVolumeExtinction::GetBorders(
  const glm::dvec3& from, const glm::dvec3& along, double first, double last) const
{
  std::vector<double> borders{ first, last };
  const auto add = [&](int axis, double at) {
    const double t = (at - from[axis]) / along[axis];
    if (t > first && t < last)
    {
      borders.push_back(t);
    }
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis] == 0.0)
    {
      continue;
    }
    for (int i = 0; i < this->Size[axis]; ++i)
    {
      add(axis, i);
      if (this->Nearest || this->Cuts.HasMask())
      {
        add(axis, i + 0.5);
      }
    }
    for (int i = 0; i < 2 && this->Cuts.GetCrop(); ++i)
    {
      add(axis, this->Cuts.GetCrop()[2 * axis + i]);
    }
  }
  std::sort(borders.begin(), borders.end());
  return borders;
}

//------------------------------------------------------------------------------
template <typename T>
double vtkRelievoVolumeExtinction::Integrate(
  const T* values, const glm::dvec3& from, const glm::dvec3& along, double first, double last) const
{
  const std::vector<double> borders = this->GetBorders(from, along, first, last);
  const double length = glm::length(this->IndexToData * along);
  const double aside = 0.5 / std::sqrt(3.0); // of the two places of Gauss's rule
  double depth = 0.0;
  for (int halving = 0; halving < MostHalvings; ++halving)
  {
    const int parts = 1 << halving;
    double sum = 0.0;
    for (std::size_t i = 1; i < borders.size(); ++i)
    {
      const double part = (borders[i] - borders[i - 1]) / parts;
      for (int j = 0; j < 2 * parts; ++j)
      {
        const double at = j / 2 + 0.5 + (j & 1 ? aside : -aside);
        const glm::dvec3 place = from + (borders[i - 1] + at * part) * along;
        sum += this->Cuts.IsThere(place) ? 0.5 * part * this->GetExact(values, place) : 0.0;
      }
    }
    sum *= length;
    const double change = std::abs(std::exp(-sum) - std::exp(-depth));
    depth = sum;
    if (halving > 0 && change < Exactness)
    {
      break;
    }
  }
  return depth;
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
  for (const glm::dvec4& plane : this->Cuts.GetPlanes())
  {
    cut(glm::dot(plane, glm::dvec4(from, 1.0)), glm::dot(glm::dvec3(plane), step));
  }
  return first < last;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExtinction::AddDepths(const glm::dvec3& from, const glm::dvec3& step,
  int samples, std::vector<float>& depths, std::vector<glm::vec3>& tints) const
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
    vtkTemplateMacro(this->March(static_cast<const VTK_TT*>(this->Array->GetVoidPointer(0)), start,
      along, first, last, samples, depths, tints));
    default:
      break;
  }
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeExtinction::GetDepth(const glm::dvec3& from, const glm::dvec3& to) const
{
  double first = 0.0;
  double last = 1.0;
  if (!this->Clip(from, to - from, first, last))
  {
    return 0.0;
  }
  const glm::dvec3 start(this->WorldToIndex * glm::dvec4(from, 1.0));
  const glm::dvec3 along(glm::dmat3(this->WorldToIndex) * (to - from));
  switch (this->Array->GetDataType())
  {
    vtkTemplateMacro(return this->Integrate(
      static_cast<const VTK_TT*>(this->Array->GetVoidPointer(0)), start, along, first, last));
    default:
      break;
  }
  return 0.0;
}
