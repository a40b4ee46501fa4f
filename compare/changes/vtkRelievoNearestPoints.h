// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pairs the points of two sets, nearest pairs first.
#ifndef vtkRelievoNearestPoints_h
#define vtkRelievoNearestPoints_h

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace relievo::compare
{
// Calls `accepts(i, j)` for the nearest of all pairs of free points; points of pairs that it
// accepts are no longer free. Of equally near pairs the first counts. A point `from` that was
// refused `tries` times remains alone. Usually takes n log n steps (k-d tree; Bentley 1975).
void PairNearest(const std::vector<std::array<double, 3>>& from,
  const std::vector<std::array<double, 3>>& to, std::size_t tries,
  const std::function<bool(std::size_t from, std::size_t to)>& accepts);
void PairNearest(const std::vector<std::array<double, 6>>& from,
  const std::vector<std::array<double, 6>>& to, std::size_t tries,
  const std::function<bool(std::size_t from, std::size_t to)>& accepts);
}

#endif
