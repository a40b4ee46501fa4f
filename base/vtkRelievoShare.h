// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Equal shares of a number of items. Computed in one place, because parts that different processes
// compute must meet without a gap.
#ifndef vtkRelievoShare_h
#define vtkRelievoShare_h

#include <algorithm>
#include <array>
#include <cstdint>

// The items of part `part`, from 1, of `parts`: the first, and the one after the last. The first
// shares have one item more if the number cannot be divided.
inline std::array<std::int64_t, 2> vtkRelievoShare(int part, int parts, std::int64_t all)
{
  const std::int64_t share = all / parts;
  const std::int64_t rest = all % parts;
  const auto begin = [&](std::int64_t before) { return before * share + std::min(before, rest); };
  return { begin(part - 1), begin(part) };
}

#endif
