// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --ground: a ground below the scene that catches its shadows.
 */
#ifndef Ground_h
#define Ground_h

#include "vtkSmartPointer.h"

class vtkActor;

namespace scene
{
struct RenderOptions;

/// A disc below these bounds, visible from above, that catches shadows: where lit, it has the
/// background's bottom colour and is invisible; it fades out towards its rim. It is translucent, so
/// that layers do not show it.
vtkSmartPointer<vtkActor> MakeGround(const double bounds[6], const RenderOptions& options);

///@{
/// Its lit colour, 0 to 1.
void GetGroundColor(vtkActor* ground, double color[3]);
void SetGroundColor(vtkActor* ground, const double color[3]);
///@}
}

#endif
