// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --light: a light of the scene in words.
 */
#ifndef LightOptions_h
#define LightOptions_h

#include <array>
#include <optional>
#include <string>

namespace scene
{
struct LightChoice
{
  enum class Kind
  {
    Sun,
    Spot,
    Point
  };
  Kind Is = Kind::Sun;
  std::array<double, 3> Position; ///< for a sun, the unit direction towards it
  bool InView = false; ///< that direction is right, up and to the camera before it is fitted
  std::array<double, 3> FocalPoint;                ///< of a spot
  double ConeAngle = 180.0;                        ///< degrees, half the opening
  std::array<double, 3> Color = { 1.0, 1.0, 1.0 }; ///< times its intensity
  bool Casts = true;                               ///< shadows, if there are any
  std::optional<double> Size; ///< a sun's angle in degrees, else a radius; none: as others are
};

/// "sun:DX,DY,DZ[,size=S]" and so on; throws UsageError.
LightChoice ParseLight(const std::string& word);
}

#endif
