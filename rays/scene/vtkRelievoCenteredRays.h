// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays of two arrays, about the centre of a scene.
#ifndef vtkRelievoCenteredRays_h
#define vtkRelievoCenteredRays_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkRelievoRayTree.h"

#include <algorithm>
#include <cmath>

class vtkRelievoCenteredRays
{
public:
  using Line = vtkRelievoRayTree::Line;
  using Hit = vtkRelievoRayTree::Hit;

  // If a ray is not Valid, it hits nothing.
  struct Ray : Line
  {
    bool Valid = false;
    bool None = false; // not a ray: causes no warning
  };

  vtkRelievoCenteredRays(vtkDataArray* origins, vtkDataArray* directions, const glm::dvec3& center)
    : Origins(origins)
    , Directions(directions)
    , Center(center)
  {
  }

  vtkIdType GetCount() const { return this->Directions->GetNumberOfTuples(); }

  Ray Get(vtkIdType row) const
  {
    Ray ray;
    Read(this->Origins, this->Origins->GetNumberOfTuples() == 1 ? 0 : row, ray.From);
    Read(this->Directions, row, ray.Direction);
    const glm::dvec3 sizes = glm::abs(ray.Direction);
    const double size = std::max(std::max(sizes.x, sizes.y), sizes.z);
    ray.Valid = size > 0.0;
    for (int i = 0; i < 3; ++i)
    {
      ray.Valid = ray.Valid && std::isfinite(ray.From[i]) && std::isfinite(ray.Direction[i]);
    }
    ray.None =
      glm::isnan(ray.Direction.x) && glm::isnan(ray.Direction.y) && glm::isnan(ray.Direction.z);
    ray.From -= this->Center;
    ray.Direction = glm::normalize(ray.Direction / size);
    return ray;
  }

  // Calls trace(lines, count, hits) for several rays at once, and take(row, line, hit) for each ray
  // from row `first` up to `last`. Returns the number of rays that are not valid.
  template <typename Trace, typename Take>
  vtkIdType ForEach(vtkIdType first, vtkIdType last, Trace trace, Take take) const
  {
    vtkIdType invalid = 0;
    Line lines[Together];
    vtkIdType rows[Together];
    Hit hits[Together];
    for (vtkIdType row = first; row < last;)
    {
      int count = 0;
      for (; row < last && count < Together; ++row)
      {
        const Ray ray = this->Get(row);
        lines[count] = ray;
        rows[count] = row;
        if (ray.Valid)
        {
          ++count;
          continue;
        }
        take(row, ray, Hit());
        invalid += ray.None ? 0 : 1;
      }
      trace(lines, count, hits);
      for (int i = 0; i < count; ++i)
      {
        take(rows[i], lines[i], hits[i]);
      }
    }
    return invalid;
  }

private:
  static constexpr vtkIdType Together = 256; // rays traced by one call

  static void Read(vtkDataArray* array, vtkIdType tuple, glm::dvec3& value)
  {
    if (auto* doubles = vtkDoubleArray::FastDownCast(array))
    {
      std::copy_n(doubles->GetPointer(3 * tuple), 3, &value.x);
      return;
    }
    array->GetTuple(tuple, &value.x);
  }

  vtkDataArray* Origins;
  vtkDataArray* Directions;
  glm::dvec3 Center;
};

#endif
