// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --ground: a ground below the scene that catches its shadows.
 */
#ifndef Ground_h
#define Ground_h

#include "LookNames.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>

class vtkActor;
class vtkRenderer;

namespace look
{
/// A disc below these bounds, visible from above, that catches shadows: where lit, it has this
/// colour, 0 to 1; in the background's bottom colour it is invisible. It fades out towards its rim.
/// It is translucent, so that layers do not show it. With a renderer, it is darker where the
/// renderer's opaque actors hide the sky.
vtkSmartPointer<vtkActor> MakeGround(const double bounds[6], int upAxis,
  const std::array<double, 3>& color, vtkRenderer* renderer = nullptr);

///@{
/// Its lit colour, 0 to 1.
void GetGroundColor(vtkActor* ground, double color[3]);
void SetGroundColor(vtkActor* ground, const double color[3]);
///@}

/// The row of --ground.
void AddGroundOption(OptionRows& rows, std::optional<bool>& ground);
}

#endif
