// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --turntable: views on a circle around the up axis.
 */
#ifndef Turntable_h
#define Turntable_h

#include "CameraOptions.h"
#include "LookNames.h"

#include <vector>

namespace look
{
/// The view, turned to the middle of these bounds and as far from it that they stay within the
/// renderer's picture on a whole turn, with the margin of fitted views.
CameraPlace FitTurn(vtkRenderer* renderer, const CameraPlace& view, int up, const double bounds[6]);

/// A view for each frame: the first one, then turned about the up axis through its focal point,
/// counter-clockwise seen from above; another frame would be the first one again.
std::vector<CameraPlace> MakeTurn(const CameraPlace& first, int frames, int up);
}

#endif
