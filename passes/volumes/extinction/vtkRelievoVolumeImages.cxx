// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeImages.h"

#include "vtkAbstractMapper.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkRelievoMatrix.h"
#include "vtkSmartPointer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::vector<vtkImageData*> vtkRelievoVolumeImages::Find(vtkDataObject* data, bool& others)
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
      const std::vector<vtkImageData*> more = Find(leaf->GetCurrentDataObject(), others);
      images.insert(images.end(), more.begin(), more.end());
    }
  }
  else
  {
    others = others || data;
  }
  return images;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkRelievoVolumeImages::GetScalars(
  vtkVolumeMapper* mapper, vtkImageData* image, int& cells)
{
  return vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName(), cells);
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeImages::IsDrawnOnProcessor(vtkAbstractVolumeMapper* mapper)
{
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  if (!smart)
  {
    return mapper && mapper->IsA("vtkFixedPointVolumeRayCastMapper");
  }
  // By default it draws with vtkOpenGLGPUVolumeRayCastMapper, which supports every volume.
  return smart->GetRequestedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode;
}

//------------------------------------------------------------------------------
int vtkRelievoVolumeImages::GetVectorPart(vtkVolumeMapper* mapper, vtkDataArray* values)
{
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  auto* blocks = vtkMultiBlockVolumeMapper::SafeDownCast(mapper);
  const int mode = smart ? smart->GetVectorMode()
    : blocks             ? blocks->GetVectorMode()
                         : vtkSmartVolumeMapper::DISABLED;
  if (mode == vtkSmartVolumeMapper::DISABLED || values->GetNumberOfComponents() < 2 ||
    IsDrawnOnProcessor(mapper))
  {
    return Everything;
  }
  return mode == vtkSmartVolumeMapper::MAGNITUDE ? Magnitude
    : smart                                      ? smart->GetVectorComponent()
                                                 : blocks->GetVectorComponent();
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeImages::FindWhyNotDrawn(
  vtkVolume* volume, vtkImageData* image, vtkDataArray* values, bool cells)
{
  auto* mapper = static_cast<vtkVolumeMapper*>(volume->GetMapper());
  const int part = GetVectorPart(mapper, values);
  const int components = part == Magnitude ? 1 : values->GetNumberOfComponents();
  if (IsDrawnOnProcessor(mapper))
  {
    return mapper->IsA("vtkSmartVolumeMapper") && (cells || components > 1)
      ? "VTK does not draw values of cells, or several components, on the processor; use "
        "SetRequestedRenderModeToGPU()"
      : "";
  }
  if (!volume->GetProperty()->GetIndependentComponents() && components != 2 && components != 4)
  {
    return "its components depend on each other (IndependentComponentsOff), but it has " +
      std::to_string(components) + ", of which VTK draws only 2 or 4";
  }
  if (part >= components)
  {
    return "its mapper draws component " + std::to_string(part) + " of " +
      std::to_string(components);
  }
  if (values->GetDataType() == VTK_CHAR)
  {
    return "VTK does not draw values of VTK_CHAR; use VTK_SIGNED_CHAR";
  }
  return image->GetDirectionMatrix()->Determinant() < 0.0
    ? "its image has left-handed axes, of which VTK culls the front; reverse one axis"
    : "";
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeImages::GetStretch(vtkDataArray* values)
{
  switch (values->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return 256.0 / 255.0;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return 128.0 / 127.0;
    case VTK_UNSIGNED_SHORT:
      return 65536.0 / 65535.0;
    case VTK_SHORT:
      return 32768.0 / 32767.0;
    default:
      return 1.0;
  }
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoVolumeImages::GetIndexToData(vtkImageData* image, bool cells, int size[3])
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
