// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeExtinction.h"

#include "vtkAbstractMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoPropMTime.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
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
// Colours are at least this bright where they colour light: a dark one blocks a channel at once.
constexpr double Darkest = 1.0 / 255.0;
constexpr double Exactness = 1e-6; // of transmittances by GetDepth
constexpr int MostHalvings = 7;

double GetExtinctionOf(double opacity, double unit)
{
  return -std::log1p(-std::min(opacity, 1.0 - Opaque)) / unit;
}

// Of a scalar, between the entries of a table.
template <typename V>
V Look(const std::vector<V>& table, float entry)
{
  const float inside = std::min(std::max(entry, 0.f), Entries - 1.f);
  const int before = std::min(static_cast<int>(inside), Entries - 2);
  return table[before] +
    (inside - static_cast<float>(before)) * (table[before + 1] - table[before]);
}

// The range of scalars that VTK's tables cover.
void GetRange(vtkDataArray* array, int component, double range[2])
{
  array->GetFiniteRange(range, component);
  if (array->GetNumberOfComponents() == 4 && array->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    range[0] = 0.0;
    range[1] = 255.0;
  }
  range[1] = range[1] > range[0] ? range[1] : range[0] + 1.0;
}

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

bool HasGradients(vtkVolumeProperty* property, int index)
{
  return property->HasGradientOpacity(index) && !property->GetDisableGradientOpacity(index);
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
  const vtkRelievoPlacedVolume& placed, bool colored, std::vector<std::uint64_t>& state)
{
  vtkVolume* volume = placed.Volume;
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  vtkVolumeProperty* property = volume->GetProperty();
  state.push_back(reinterpret_cast<std::uintptr_t>(volume));
  bool others = false;
  vtkDataArray* scalars = nullptr;
  for (vtkImageData* image :
    mapper ? FindImages(mapper->GetDataObjectInput(), others) : std::vector<vtkImageData*>())
  {
    int cells = 0;
    scalars = scalars ? scalars : GetScalars(mapper, image, cells);
  }
  const int functions =
    scalars && property->GetIndependentComponents() ? scalars->GetNumberOfComponents() : 1;
  // Without coefficients of light, which extinction does not depend on.
  for (int i = 0; i < std::min(functions, VTK_MAX_VRCOMP); ++i)
  {
    state.push_back(property->GetScalarOpacity(i)->GetMTime());
    state.push_back(HasGradients(property, i) ? property->GetGradientOpacity(i)->GetMTime() : 0);
    AddDouble(state, property->GetScalarOpacityUnitDistance(i));
    AddDouble(state, property->GetComponentWeight(i));
    if (colored)
    {
      state.push_back(property->GetColorChannels(i) == 1
          ? property->GetGrayTransferFunction(i)->GetMTime()
          : property->GetRGBTransferFunction(i)->GetMTime());
    }
  }
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
  auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  if (vtkImageData* mask = gpu ? gpu->GetMaskInput() : nullptr)
  {
    state.push_back(gpu->GetMaskType());
    state.push_back(vtkRelievoPropMTime::OfData(mask));
  }
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

    const glm::dmat4 indexToData = GetIndexToData(image, cells != 0, field.Size);
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
    field.SetCuts(mapper, indexToData);
    field.Hide(image, cells != 0);
    why = field.Mask(mapper);
    if (!why.empty())
    {
      return {};
    }
    for (int i = 0; i < (independent ? components : 1); ++i)
    {
      // The last of two or four dependent components is the opacity's.
      Channel channel = field.MakeChannel(property, image, independent ? i : components - 1, i);
      const bool seen = *std::max_element(channel.Extinction.begin(), channel.Extinction.end()) > 0;
      // VTK weights components only if there are several.
      channel.Weight = independent ? channel.Weight : 1.f;
      if (seen && channel.Weight > 0.f)
      {
        if (colored)
        {
          channel.AddTints(property, field.Array, i);
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
// Clipping planes and cropping.
void vtkRelievoVolumeExtinction::SetCuts(vtkVolumeMapper* mapper, const glm::dmat4& indexToData)
{
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      const double* n = plane->GetNormal();
      const double* o = plane->GetOrigin();
      this->Planes.emplace_back(n[0], n[1], n[2], -(n[0] * o[0] + n[1] * o[1] + n[2] * o[2]));
    }
  }
  if (mapper->GetCropping())
  {
    this->Cropped = mapper->GetCroppingRegionFlags();
    const double* planes = mapper->GetCroppingRegionPlanes();
    const glm::dmat4 dataToIndex = glm::inverse(indexToData);
    for (int i = 0; i < 6; ++i)
    {
      glm::dvec4 place(0.0, 0.0, 0.0, 1.0);
      place[i / 2] = planes[i];
      this->Crop[i] = (dataToIndex * place)[i / 2];
    }
  }
}

//------------------------------------------------------------------------------
// Nothing is drawn between samples of which one is blanked, or in a blanked cell.
void vtkRelievoVolumeExtinction::Hide(vtkImageData* image, bool cells)
{
  vtkUnsignedCharArray* points = cells ? nullptr : image->GetPointGhostArray();
  vtkUnsignedCharArray* hidden = image->GetCellGhostArray();
  const auto has = [](vtkUnsignedCharArray* ghosts, int flag) {
    return ghosts &&
      std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(0) + ghosts->GetNumberOfTuples(),
        [flag](unsigned char ghost) { return (ghost & flag) != 0; });
  };
  const bool any = has(points, vtkDataSetAttributes::HIDDENPOINT);
  const bool anyCell = has(hidden, vtkDataSetAttributes::HIDDENCELL);
  if (!any && !anyCell)
  {
    return;
  }
  int size[3];
  for (int i = 0; i < 3; ++i)
  {
    size[i] = std::max(1, this->Size[i] - 1);
  }
  this->Hidden = std::make_shared<std::vector<bool>>();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        bool hides = anyCell && !cells &&
          (hidden->GetValue(i + size[0] * (j + static_cast<vtkIdType>(size[1]) * k)) &
            vtkDataSetAttributes::HIDDENCELL) != 0;
        for (int corner = 0; corner < 8 && (any || cells); ++corner)
        {
          const vtkIdType x = std::min(i + (corner & 1), this->Size[0] - 1);
          const vtkIdType y = std::min(j + (corner >> 1 & 1), this->Size[1] - 1);
          const vtkIdType z = std::min(k + (corner >> 2), this->Size[2] - 1);
          const vtkIdType at = x + this->Size[0] * (y + this->Size[1] * z);
          hides = hides ||
            (cells ? (hidden->GetValue(at) & vtkDataSetAttributes::HIDDENCELL) != 0
                   : (points->GetValue(at) & vtkDataSetAttributes::HIDDENPOINT) != 0);
        }
        this->Hidden->push_back(hides);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A binary mask, which VTK looks up at the nearest sample. Returns why it cannot be used, or "".
std::string vtkRelievoVolumeExtinction::Mask(vtkVolumeMapper* mapper)
{
  auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  vtkImageData* mask = gpu ? gpu->GetMaskInput() : nullptr;
  if (!mask)
  {
    return std::string();
  }
  int cells = 0;
  vtkDataArray* values = GetScalars(mapper, mask, cells);
  const vtkIdType count = static_cast<vtkIdType>(this->Size[0]) * this->Size[1] * this->Size[2];
  if (!values || values->GetNumberOfTuples() != count)
  {
    return "its mask and its image have different numbers of values; give the mask the image's "
           "dimensions";
  }
  this->Masked = std::make_shared<std::vector<bool>>(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    (*this->Masked)[static_cast<std::size_t>(i)] = !(values->GetComponent(i, 0) > 0.0);
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExtinction::Curve::Set(vtkPiecewiseFunction* function)
{
  this->Function = function;
  bool linear = function->GetClamping() != 0;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // with the place of the middle and the sharpness
    function->GetNodeValue(i, node);
    this->Nodes.emplace_back(node[0], node[1]);
    linear = linear && node[2] == 0.5 && node[3] == 0.0;
  }
  if (!linear)
  {
    this->Nodes.clear();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeExtinction::Curve::Get(double x) const
{
  if (this->Nodes.empty())
  {
    return this->Function->GetValue(x);
  }
  const auto after = std::lower_bound(this->Nodes.begin(), this->Nodes.end(), x,
    [](const glm::dvec2& node, double value) { return node.x < value; });
  if (after == this->Nodes.begin() || after == this->Nodes.end())
  {
    return (after == this->Nodes.end() ? this->Nodes.back() : *after).y;
  }
  const glm::dvec2& before = *(after - 1);
  return before.y + (x - before.x) / (after->x - before.x) * (after->y - before.y);
}

//------------------------------------------------------------------------------
vtkRelievoVolumeExtinction::Channel vtkRelievoVolumeExtinction::MakeChannel(
  vtkVolumeProperty* property, vtkImageData* image, int component, int function) const
{
  Channel channel;
  channel.Component = component;
  channel.Weight = static_cast<float>(property->GetComponentWeight(function));
  double* range = channel.Range;
  GetRange(this->Array, component, range);
  channel.Opacity.Set(property->GetScalarOpacity(function));
  channel.Unit = std::max(1e-300, property->GetScalarOpacityUnitDistance(function));
  std::vector<float> opacities(Entries);
  property->GetScalarOpacity(function)->GetTable(range[0], range[1], Entries, opacities.data());
  channel.Extinction.resize(Entries);
  std::transform(opacities.begin(), opacities.end(), channel.Extinction.begin(),
    [&](float opacity) { return static_cast<float>(GetExtinctionOf(opacity, channel.Unit)); });
  channel.First = static_cast<float>(range[0]);
  channel.PerScalar = static_cast<float>((Entries - 1) / (range[1] - range[0]));
  if (HasGradients(property, function))
  {
    vtkPiecewiseFunction* gradients = property->GetGradientOpacity(function);
    channel.Gradient.Set(gradients);
    channel.GradientOpacity.resize(Entries);
    channel.Steepest = 0.25 * (range[1] - range[0]);
    gradients->GetTable(0.0, channel.Steepest, Entries, channel.GradientOpacity.data());
    const glm::dvec3 spacing(
      image->GetSpacing()[0], image->GetSpacing()[1], image->GetSpacing()[2]);
    const double mean = (spacing.x + spacing.y + spacing.z) / 3.0;
    channel.Weights = glm::vec3(mean / (2.0 * spacing));
  }
  return channel;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExtinction::Channel::AddTints(
  vtkVolumeProperty* property, vtkDataArray* array, int function)
{
  const int components = array->GetNumberOfComponents();
  if (components == 4 && !property->GetIndependentComponents())
  {
    return; // the colours are in the data
  }
  // Of two dependent components the first is the colour's.
  this->TintBy = components == 2 && !property->GetIndependentComponents() ? 0 : this->Component;
  double range[2];
  GetRange(array, this->TintBy, range);
  this->FirstTint = static_cast<float>(range[0]);
  this->PerTint = static_cast<float>((Entries - 1) / (range[1] - range[0]));
  std::vector<float> colors(3 * Entries);
  if (property->GetColorChannels(function) == 1)
  {
    property->GetGrayTransferFunction(function)->GetTable(
      range[0], range[1], Entries, colors.data(), 3);
    for (int i = 0; i < Entries; ++i)
    {
      colors[3 * i + 1] = colors[3 * i + 2] = colors[3 * i];
    }
  }
  else
  {
    property->GetRGBTransferFunction(function)->GetTable(
      range[0], range[1], Entries, colors.data());
  }
  bool white = true;
  this->Tints.resize(Entries);
  for (int i = 0; i < Entries; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double color = std::min(std::max<double>(colors[3 * i + j], Darkest), 1.0);
      this->Tints[i][j] = static_cast<float>(-std::log(color));
      white = white && color == 1.0;
    }
  }
  if (white)
  {
    this->Tints.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExtinction::HasTints() const
{
  return std::any_of(this->Channels.begin(), this->Channels.end(),
    [](const Channel& channel) { return !channel.Tints.empty(); });
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
// Within the cropping, between samples that are not hidden, near one that is not masked.
template <typename Real>
inline bool vtkRelievoVolumeExtinction::IsThere(const glm::vec<3, Real>& place) const
{
  if (this->Cropped >= 0)
  {
    int region = 0;
    for (int axis = 0, stride = 1; axis < 3; ++axis, stride *= 3)
    {
      const double at = place[axis];
      region += stride * (at <= this->Crop[2 * axis] ? 0 : at <= this->Crop[2 * axis + 1] ? 1 : 2);
    }
    if ((this->Cropped >> region & 1) == 0)
    {
      return false;
    }
  }
  const auto find = [&](const std::vector<bool>& flags, int less, Real round) {
    std::size_t at = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int size = std::max(1, this->Size[axis] - less);
      const int number = static_cast<int>(std::floor(place[axis] + round));
      at = at * size + std::min(std::max(number, 0), size - 1);
    }
    return flags[at];
  };
  return !(this->Hidden && find(*this->Hidden, 1, Real(0))) &&
    !(this->Masked && find(*this->Masked, 0, Real(0.5)));
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
  const Channel& channel, const T* values, const glm::vec3& place) const
{
  const float entry =
    (this->GetScalar(values, channel.Component, place) - channel.First) * channel.PerScalar;
  if (std::isnan(entry))
  {
    return 0.f;
  }
  float extinction = Look(channel.Extinction, entry);
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
      : Look(
          channel.GradientOpacity, static_cast<float>(length / channel.Steepest) * (Entries - 1.f));
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
  for (const Channel& channel : this->Channels)
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
      const glm::vec3 tint = Look(channel.Tints, std::isnan(entry) ? 0.f : entry);
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
  for (const Channel& channel : this->Channels)
  {
    const double* range = channel.Range;
    const double scalar = this->GetScalar(values, channel.Component, place);
    if (std::isnan(scalar))
    {
      continue;
    }
    double extinction = GetExtinctionOf(
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
  const bool cut = this->Cropped >= 0 || this->Hidden || this->Masked;
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
      if (cut && !this->IsThere(place))
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
      if (this->Nearest || this->Masked)
      {
        add(axis, i + 0.5);
      }
    }
    for (int i = 0; i < 2 && this->Cropped >= 0; ++i)
    {
      add(axis, this->Crop[2 * axis + i]);
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
        sum += this->IsThere(place) ? 0.5 * part * this->GetExact(values, place) : 0.0;
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
  for (const glm::dvec4& plane : this->Planes)
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
