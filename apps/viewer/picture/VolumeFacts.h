// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values and the opacity of a picture's first volume.
 */
#ifndef VolumeFacts_h
#define VolumeFacts_h

#include <array>
#include <optional>
#include <vector>

namespace viewer
{
class Picture;

struct VolumeFacts
{
  std::array<double, 2> Range{};
  std::vector<double> Histogram;              ///< numbers of values in equal parts of the range
  std::vector<std::array<double, 2>> Opacity; ///< values and opacities, within the range
};

/// None without a volume. The histogram is kept while the data is unchanged.
std::optional<VolumeFacts> GetVolumeFacts(const Picture& picture);
}

#endif
