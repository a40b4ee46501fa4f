// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The default camera: its direction and its distance.
 */
#ifndef FittedView_h
#define FittedView_h

#include "LookNames.h"

#include <array>

class vtkRenderer;

namespace look
{
class FittedView
{
public:
  static constexpr double Filled = 0.84; ///< share of the picture that the fitted bounds fill

  /// A view along an axis, with the axis `up` (0, 1, 2 for x, y, z) upwards: along -z with y up.
  explicit FittedView(int up);

  /// The world direction of a unit vector (right, up, towards the camera) before any turn.
  std::array<double, 3> ToWorld(const std::array<double, 3>& right_up_near) const;

  /// Whether one extent is negligible beside the others.
  static bool IsFlat(const double bounds[6]);

  /// If the camera would see a flat scene edge-on, turns it to the flat side, from above or from
  /// the right.
  void TurnToFlatSide(const double bounds[6]);

  /// Turns the camera to this direction: right, up, near.
  void TurnTo(const std::array<double, 3>& right_up_near);

  ///@{
  /// Places the renderer's camera, keeping its angle and projection. Fit() uses VTK's distance,
  /// from which any rotation fits; FitTightly() fits the corners of these bounds, with a margin.
  void Fit(vtkRenderer* renderer, const double bounds[6]) const;
  void FitTightly(vtkRenderer* renderer, const double bounds[6]) const;
  ///@}

private:
  void Turn(vtkRenderer* renderer) const;

  int Up;
  std::array<double, 3> Towards; // direction to the camera
  std::array<double, 3> ViewUp{};
};
}

#endif
