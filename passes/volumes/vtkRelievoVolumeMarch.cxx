// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeMarch.h"

#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneCollection.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkRelievoVolumesStage.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
bool IsUsual(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, vtkImageData* image)
{
  vtkVolumeProperty* property = volume->GetProperty();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  return mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND && !mapper->GetCropping() &&
    (!planes || planes->GetNumberOfItems() == 0) && !mapper->GetMaskInput() &&
    mapper->GetScalarOpacityRangeType() == vtkGPUVolumeRayCastMapper::SCALAR &&
    property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D &&
    !property->HasGradientOpacity() && !image->HasAnyGhostCells() && !image->GetPointGhostArray() &&
    volume->GetShaderProperty()->GetNumberOfShaderReplacements() == 0;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeMarch::Take(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, int longest)
{
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (!image || !IsUsual(mapper, volume, image))
  {
    return false;
  }
  int cells = 0;
  this->Values = vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
  if (!this->Values || this->Values->GetNumberOfComponents() != 1)
  {
    return false;
  }
  int points[3];
  image->GetDimensions(points);
  this->Size = glm::ivec3(points[0], points[1], points[2]) - (cells ? 1 : 0);
  this->Shift = cells ? 0.5 : 0.0;
  this->Image = image;
  this->Time = std::max(this->Values->GetMTime(), image->GetMTime());
  this->Values->GetFiniteRange(this->Range);
  this->Memory = this->Values->GetVoidPointer(0);
  vtkVolumeProperty* property = volume->GetProperty();
  this->Linear = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  this->UnitDistance = property->GetScalarOpacityUnitDistance();
  this->Function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  this->Function->DeepCopy(property->GetScalarOpacity());
  this->Longest = longest;
  return this->Range[0] < this->Range[1] &&
    static_cast<vtkIdType>(this->Size.x) * this->Size.y * this->Size.z ==
    this->Values->GetNumberOfTuples();
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeMarch::IsUnchanged() const
{
  // An image whose values were changed in place is modified, its array perhaps not; an array that
  // has grown has other memory.
  return std::max(this->Values->GetMTime(), this->Image->GetMTime()) == this->Time &&
    this->Values->GetVoidPointer(0) == this->Memory &&
    this->Values->GetNumberOfTuples() ==
    static_cast<vtkIdType>(this->Size.x) * this->Size.y * this->Size.z;
}

//------------------------------------------------------------------------------
// VTK's table: the size of vtkOpenGLVolumeLookupTable, corrected by unit distance
// (vtkOpenGLVolumeOpacityTable).
void vtkRelievoVolumeMarch::SetStep(double length)
{
  const int needed = this->Function->EstimateMinNumberOfSamples(this->Range[0], this->Range[1]);
  const int size = std::min(this->Longest, std::max(1024, vtkMath::NearestPowerOfTwo(needed)));
  this->Opacities.resize(static_cast<std::size_t>(size));
  this->Function->GetTable(this->Range[0], this->Range[1], size, this->Opacities.data());
  for (double& opacity : this->Opacities)
  {
    if (opacity > 0.0001)
    {
      opacity = 1.0 - std::pow(1.0 - opacity, length / this->UnitDistance);
    }
  }
}

//------------------------------------------------------------------------------
// By OpenGL's filter, without the offset of half a texel at the table's ends.
double vtkRelievoVolumeMarch::GetOpacity(double value) const
{
  const double read = value * vtkRelievoVolumeImages::GetStretch(this->Values);
  const double share = (read - this->Range[0]) / (this->Range[1] - this->Range[0]);
  if (std::isnan(share))
  {
    return 0.0;
  }
  const double last = static_cast<double>(this->Opacities.size() - 1);
  const double width = static_cast<double>(this->Opacities.size());
  if (!this->Linear)
  {
    return this
      ->Opacities[static_cast<std::size_t>(glm::clamp(std::floor(share * width), 0.0, last))];
  }
  const double place = glm::clamp(share * width - 0.5, 0.0, last);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, this->Opacities.size() - 1);
  return glm::mix(this->Opacities[low], this->Opacities[high], place - static_cast<double>(low));
}

//------------------------------------------------------------------------------
template <typename Value>
double vtkRelievoVolumeMarch::Interpolate(const Value* values, const glm::dvec3& position) const
{
  const glm::dvec3 last = glm::dvec3(this->Size - 1);
  glm::dvec3 at = position - this->Shift;
  at = glm::clamp(this->Linear ? at : glm::floor(at + 0.5), glm::dvec3(0.0), last);
  const glm::ivec3 low(at);
  const glm::dvec3 part = at - glm::dvec3(low);
  const vtkIdType along[3] = { part.x > 0.0 ? 1 : 0, part.y > 0.0 ? this->Size.x : 0,
    part.z > 0.0 ? static_cast<vtkIdType>(this->Size.x) * this->Size.y : 0 };
  const vtkIdType first =
    low.x + this->Size.x * (low.y + static_cast<vtkIdType>(this->Size.y) * low.z);
  double rows[4];
  for (int i = 0; i < 4; ++i)
  {
    const vtkIdType row = first + (i % 2) * along[1] + (i / 2) * along[2];
    rows[i] = glm::mix(
      static_cast<double>(values[row]), static_cast<double>(values[row + along[0]]), part.x);
  }
  return glm::mix(glm::mix(rows[0], rows[1], part.y), glm::mix(rows[2], rows[3], part.y), part.z);
}

//------------------------------------------------------------------------------
template <typename Value>
double vtkRelievoVolumeMarch::March(const Value* values, const glm::dvec3& entry,
  const glm::dvec3& step, int rule, double threshold, int first, int last) const
{
  using Stage = vtkRelievoVolumesStage;
  double found = std::numeric_limits<double>::quiet_NaN();
  double passes = 1.0;
  double most = 0.0;
  for (int k = rule == Stage::FIRST ? first : 1; k <= last; ++k)
  {
    const double opacity =
      this->GetOpacity(this->Interpolate(values, entry + static_cast<double>(k) * step));
    const double after = passes * (1.0 - opacity);
    if (rule == Stage::FIRST && opacity > 0.0)
    {
      return k;
    }
    if (rule == Stage::OPACITY && after <= 1.0 - threshold)
    {
      const double part =
        after > 0.0 ? std::log((1.0 - threshold) / passes) / std::log(after / passes) : 0.0;
      return k - 1.0 + part;
    }
    if (rule == Stage::STRONGEST && k >= first && passes - after > most)
    {
      most = passes - after;
      found = k;
    }
    passes = after;
  }
  return found;
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeMarch::GetValue(const glm::dvec3& position) const
{
  switch (this->Values->GetDataType())
  {
    vtkTemplateMacro(return this->Interpolate(static_cast<const VTK_TT*>(this->Memory), position));
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeMarch::FindStep(const glm::dvec3& entry, const glm::dvec3& step, int rule,
  double threshold, int first, int last) const
{
  switch (this->Values->GetDataType())
  {
    vtkTemplateMacro(return this->March(
      static_cast<const VTK_TT*>(this->Memory), entry, step, rule, threshold, first, last));
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}
