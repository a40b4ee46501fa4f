// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of an image that are not drawn: by cropping, clipping planes, binary masks, and blanked
// points and cells.
#ifndef vtkRelievoVolumeCuts_h
#define vtkRelievoVolumeCuts_h

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeMapper;

class vtkRelievoVolumeCuts
{
public:
  // `size`: the number of samples, which are points or the centres of cells. Returns why the mask
  // cannot be used, as the end of a sentence, or "".
  std::string Set(vtkVolumeMapper* mapper, vtkImageData* image, bool cells, const int size[3],
    const glm::dmat4& indexToData);

  // Clipping planes in world coordinates: positive inside.
  const std::vector<glm::dvec4>& GetPlanes() const { return this->Planes; }

  // Whether something other than planes cuts the image, and whether a mask does.
  bool CutsInside() const { return this->Cropped >= 0 || this->Hidden || this->Masked; }
  bool HasMask() const { return this->Masked != nullptr; }

  // Two places along each axis at which cropping begins and ends, in indices of samples; nullptr
  // without cropping.
  const double* GetCrop() const { return this->Cropped >= 0 ? this->Crop : nullptr; }

  // Whether a place, in indices of samples, is within the cropping, between samples that are not
  // hidden, near one that is not masked.
  template <typename Real>
  bool IsThere(const glm::vec<3, Real>& place) const;

private:
  void SetCropping(vtkVolumeMapper* mapper, const glm::dmat4& indexToData);
  void SetPlanes(vtkVolumeMapper* mapper);
  void Hide(vtkImageData* image, bool cells);
  std::string Mask(vtkVolumeMapper* mapper);

  int Size[3] = { 1, 1, 1 };
  std::vector<glm::dvec4> Planes;
  int Cropped = -1;                      // flags of the 27 regions; -1: none is cut
  double Crop[6] = { 0, 0, 0, 0, 0, 0 }; // in indices of samples
  // Whether nothing is drawn between a sample and the next ones; of samples, whether their mask is
  // 0. Null: drawn everywhere.
  std::shared_ptr<std::vector<bool>> Hidden;
  std::shared_ptr<std::vector<bool>> Masked;
};

//------------------------------------------------------------------------------
template <typename Real>
inline bool vtkRelievoVolumeCuts::IsThere(const glm::vec<3, Real>& place) const
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

#endif
