// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPlacedVolume.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoPropMTime.h"
#include "vtkRelievoVolumeChannel.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cstring>
#include <functional>

namespace
{
void AddDouble(std::vector<std::uint64_t>& state, double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  state.push_back(bits);
}
}

//------------------------------------------------------------------------------
vtkRelievoPlacedVolume::vtkRelievoPlacedVolume(vtkVolume* volume, vtkMatrix4x4* toWorld)
  : Volume(volume)
  , ToWorld(vtkRelievoToGlm(toWorld ? toWorld : volume->GetMatrix()))
{
}

//------------------------------------------------------------------------------
std::string vtkRelievoPlacedVolume::FindWhyNotPlaced(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (volume->IsA("vtkMultiVolume"))
  {
    return "it is a vtkMultiVolume; use a vtkVolume for each of its volumes";
  }
  if (vtkRelievoVolumeImages::IsDrawnOnProcessor(mapper))
  {
    return "its mapper draws on the processor; use a vtkGPUVolumeRayCastMapper";
  }
  bool others = false;
  const bool any = !vtkRelievoVolumeImages::Find(mapper->GetDataObjectInput(), others).empty();
  return others || !any ? "its data are not a vtkImageData" : "";
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoPlacedVolume::GetTextureToWorld(vtkVolumeMapper* mapper, vtkVolume* volume)
{
  glm::dmat4 textureToIndex(1.0);
  glm::dmat4 indexToData(1.0);
  if (auto* image = vtkImageData::SafeDownCast(mapper->GetDataObjectInput()))
  {
    int cells = 0;
    int size[3];
    vtkRelievoVolumeImages::GetScalars(mapper, image, cells);
    indexToData = vtkRelievoVolumeImages::GetIndexToData(image, cells != 0, size);
    for (int i = 0; i < 3; ++i)
    {
      textureToIndex[i][i] = size[i];
      textureToIndex[3][i] = -0.5;
    }
  }
  return vtkRelievoToGlm(volume->GetMatrix()) * indexToData * textureToIndex;
}

//------------------------------------------------------------------------------
void vtkRelievoPlacedVolume::AddState(bool colored, std::vector<std::uint64_t>& state) const
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper());
  vtkVolumeProperty* property = this->Volume->GetProperty();
  state.push_back(reinterpret_cast<std::uintptr_t>(this->Volume));
  bool others = false;
  vtkDataArray* scalars = nullptr;
  for (vtkImageData* image : mapper
      ? vtkRelievoVolumeImages::Find(mapper->GetDataObjectInput(), others)
      : std::vector<vtkImageData*>())
  {
    int cells = 0;
    scalars = scalars ? scalars : vtkRelievoVolumeImages::GetScalars(mapper, image, cells);
  }
  const int functions =
    scalars && property->GetIndependentComponents() ? scalars->GetNumberOfComponents() : 1;
  // Without coefficients of light, which extinction does not depend on.
  for (int i = 0; i < std::min(functions, VTK_MAX_VRCOMP); ++i)
  {
    state.push_back(property->GetScalarOpacity(i)->GetMTime());
    state.push_back(vtkRelievoVolumeChannel::HasGradients(property, i)
        ? property->GetGradientOpacity(i)->GetMTime()
        : 0);
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
  std::for_each(
    &this->ToWorld[0].x, &this->ToWorld[0].x + 16, [&](double value) { AddDouble(state, value); });
  if (!mapper)
  {
    return;
  }
  state.push_back(vtkRelievoVolumeImages::IsDrawnOnProcessor(mapper) ? 1 : 0);
  state.push_back(scalars ? vtkRelievoVolumeImages::GetVectorPart(mapper, scalars) : 0);
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
