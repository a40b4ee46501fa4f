// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --ground: what the scene stands on, for its shadows to fall on.
 */
#ifndef Ground_h
#define Ground_h

#include "vtkSmartPointer.h"

class vtkActor;

namespace scene
{
struct RenderOptions;

/// A disc below these bounds, seen from above, that catches shadows: where light reaches it, it has
/// the background's colour at the bottom and cannot be told from that, and it fades away outwards.
/// It is translucent, so that layers do not have it.
vtkSmartPointer<vtkActor> MakeGround(const double bounds[6], const RenderOptions& options);

///@{
/// Its colour, 0 to 1, where the lights reach it.
void GetGroundColor(vtkActor* ground, double color[3]);
void SetGroundColor(vtkActor* ground, const double color[3]);
///@}
}

#endif
