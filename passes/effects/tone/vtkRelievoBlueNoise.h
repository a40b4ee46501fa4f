// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Thresholds for dithering without low frequencies: blue noise, by void and cluster (R. Ulichney,
// The void-and-cluster method for dither array generation, 1993).
#ifndef vtkRelievoBlueNoise_h
#define vtkRelievoBlueNoise_h

#include <vector>

namespace vtkRelievoBlueNoise
{
constexpr int Size = 64; // a power of 2; repeats without a seam

// Row by row: every (rank + 0.5) / Size^2 once. Computed by the first call; the same on every
// machine.
const std::vector<float>& GetThresholds();
}

#endif
