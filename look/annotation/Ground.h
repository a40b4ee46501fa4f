// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --ground: what the scene stands on, for its shadows to fall on.
 */
#ifndef Ground_h
#define Ground_h

#include "vtkSmartPointer.h"

#include <array>

class vtkActor;

namespace scene
{
/// A disc below these bounds, seen from above, that catches shadows. Where light reaches it, it has
/// this colour, 0 to 1: with the background's colour at the bottom it cannot be told from that. It
/// fades away outwards, and is translucent, so that layers do not have it.
vtkSmartPointer<vtkActor> MakeGround(
  const double bounds[6], int upAxis, const std::array<double, 3>& color);

///@{
/// Its colour, 0 to 1, where the lights reach it.
void GetGroundColor(vtkActor* ground, double color[3]);
void SetGroundColor(vtkActor* ground, const double color[3]);
///@}
}

#endif
