// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeCuts.h"

#include "vtkDataSetAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkUnsignedCharArray.h"

#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeCuts::Set(vtkVolumeMapper* mapper, vtkImageData* image, bool cells,
  const int size[3], const glm::dmat4& indexToData)
{
  std::copy(size, size + 3, this->Size);
  this->SetPlanes(mapper);
  this->SetCropping(mapper, indexToData);
  this->Hide(image, cells);
  return this->Mask(mapper);
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeCuts::SetPlanes(vtkVolumeMapper* mapper)
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
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeCuts::SetCropping(vtkVolumeMapper* mapper, const glm::dmat4& indexToData)
{
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
void vtkRelievoVolumeCuts::Hide(vtkImageData* image, bool cells)
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
std::string vtkRelievoVolumeCuts::Mask(vtkVolumeMapper* mapper)
{
  auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  vtkImageData* mask = gpu ? gpu->GetMaskInput() : nullptr;
  if (!mask)
  {
    return std::string();
  }
  int cells = 0;
  vtkDataArray* values = vtkRelievoVolumeImages::GetScalars(mapper, mask, cells);
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
