// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Thresholds for dithering whose pattern has no low frequencies: blue noise, by void and cluster
// (R. Ulichney, The void-and-cluster method for dither array generation, 1993).
#ifndef vtkRelievoBlueNoise_h
#define vtkRelievoBlueNoise_h

#include <vector>

namespace vtkRelievoBlueNoise
{
constexpr int Size = 64; // a power of 2; repeats without a seam

// By rows: every (rank + 0.5) / Size^2 once. Made at the first call, the same everywhere.
const std::vector<float>& GetThresholds();
}

#endif
