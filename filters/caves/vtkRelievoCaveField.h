// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCaveField.h
 * @brief Where caves are: two noises of different seeds that both lie in a shell.
 */
#ifndef vtkRelievoCaveField_h
#define vtkRelievoCaveField_h

#include <array>

namespace relievo
{
/** A place in cells of the noise. */
using CavePlace = std::array<double, 3>;

struct CaveField
{
  std::array<unsigned int, 2> Seeds = {};
  CavePlace Cells = {}; // a world unit along each axis
  double Middle = 0.;   // of the shell
  double PerHalf = 10.; // one over half its thickness

  /** The widest tunnels that there are, in cells. */
  static constexpr double Widest = 0.5;

  /**
   * Half the thickness of the shell around 0 that makes tunnels so wide, in cells: the mean length
   * of air along lines. With V the volume of air and S the area of its walls that is 4 V / S. The
   * share of one noise within h is P(h), its density p(h) and its mean slope there G(h), so V
   * = P^2 and S = 4 p G P, and the width P / (p G), which is 2 h / G where h is small. P, p and G
   * were measured over 4e6 places; this is within 2 % of what they give.
   */
  static double HalfOf(double width) { return width * (1.2 - width * width); }

  CavePlace PlaceOf(const double point[3]) const
  {
    return { point[0] * this->Cells[0], point[1] * this->Cells[1], point[2] * this->Cells[2] };
  }

  /** How far a noise is from the shell: -1 in its middle, 0 at its sides. */
  double WallOf(double noise) const
  {
    const double away = noise - this->Middle;
    return (away < 0. ? -away : away) * this->PerHalf - 1.;
  }

  /** WallOf each noise. */
  std::array<double, 2> WallsAt(const CavePlace& place) const;

  /** The gradient of WallOf one noise, a cell. */
  std::array<double, 3> GradientAt(const CavePlace& place, int which) const;
};
}

#endif
