// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a camera stands, as options have it.
 */
#ifndef CameraPlace_h
#define CameraPlace_h

#include "Options.h"

class vtkCamera;

namespace viewer
{
constexpr double StandardViewAngle = 30.0; // VTK's

cli::CameraPlace GetPlace(vtkCamera* camera);
}

#endif
