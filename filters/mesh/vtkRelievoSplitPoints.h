// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoSplitPoints.h
 * @brief Splits points of a mesh where polygons cannot share one point.
 */
#ifndef vtkRelievoSplitPoints_h
#define vtkRelievoSplitPoints_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace relievo
{
/**
 * Splits points by the values that their corners request: Count numbers. The first request for a
 * point gets the point itself; requests with other values get a new point at the end.
 */
template <std::size_t Count>
class PointSplitter
{
public:
  using Values = std::array<float, Count>;

  explicit PointSplitter(vtkIdType numberOfPoints)
    : Originals(numberOfPoints)
    , Asked(numberOfPoints, Slot{ Values{}, false, -1 })
  {
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      this->Originals[i] = i;
    }
  }

  /** The point to use in place of `point` by a corner with these values. */
  vtkIdType Get(vtkIdType point, const Values& values)
  {
    if (!this->Asked[point].Used)
    {
      this->Asked[point] = { values, true, -1 };
      return point;
    }
    vtkIdType slot = point;
    while (this->Asked[slot].Of != values)
    {
      if (this->Asked[slot].Next < 0)
      {
        const auto added = static_cast<vtkIdType>(this->Asked.size());
        this->Asked[slot].Next = added;
        this->Asked.push_back({ values, true, -1 });
        this->Originals.push_back(point);
        return added;
      }
      slot = this->Asked[slot].Next;
    }
    return slot;
  }

  /** The input point of each output point. */
  const std::vector<vtkIdType>& GetOriginals() const { return this->Originals; }

  /** The values requested for an output point; zeros if there was no request. */
  const Values& GetValues(vtkIdType point) const { return this->Asked[point].Of; }

private:
  struct Slot
  {
    Values Of;
    bool Used;
    vtkIdType Next;
  };

  std::vector<vtkIdType> Originals;
  std::vector<Slot> Asked;
};

/**
 * Makes `output` the mesh `input` with the points `originals` (numbers of points of the input, the
 * input's own first) and polygons that use the points `corners`, corner by corner. Point data is
 * copied to the added points; "vtkOriginalPointIds" holds `originals`.
 */
void SplitPoints(vtkPolyData* input, const std::vector<vtkIdType>& originals,
  const std::vector<vtkIdType>& corners, vtkPolyData* output);
}

#endif
