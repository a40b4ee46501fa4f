// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the camera stands if nobody says so: how it is turned, and how far away it is.
 */
#ifndef FittedView_h
#define FittedView_h

#include <array>

class vtkRenderer;

namespace scene
{
class FittedView
{
public:
  /// Along an axis, with this one (0, 1, 2 for x, y, z) upwards: along -z with y up.
  explicit FittedView(int up);

  /// A unit vector to the right, upwards and to the camera, as it stands before it is turned.
  std::array<double, 3> ToWorld(const std::array<double, 3>& right_up_near) const;

  /// Whether an extent is nothing beside the others.
  static bool IsFlat(const double bounds[6]);

  /// If a flat scene's edge alone were seen: looks at its flat side, from above or from the right.
  void TurnToFlatSide(const double bounds[6]);

  /// Looks from there, to the right, upwards and near.
  void TurnTo(const std::array<double, 3>& right_up_near);

  ///@{
  /// Places the renderer's camera, whose angle and projection stay: as VTK does, so that any turn
  /// fits in the picture, or so that the corners of these bounds fit, with a margin.
  void Fit(vtkRenderer* renderer, const double bounds[6]) const;
  void FitTightly(vtkRenderer* renderer, const double bounds[6]) const;
  ///@}

private:
  void Turn(vtkRenderer* renderer) const;

  int Up;
  std::array<double, 3> Towards; // the camera
  std::array<double, 3> ViewUp{};
};
}

#endif
