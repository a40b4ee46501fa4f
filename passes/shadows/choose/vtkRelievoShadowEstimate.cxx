// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowEstimate.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
double vtkRelievoShadowErrorLaw::GetShare(int mapSize) const
{
  return std::min(1.0, this->At2048 * std::pow(mapSize / 2048.0, -this->Power));
}
