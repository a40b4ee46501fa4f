// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --light: a light of the scene in words.
 */
#ifndef LightOptions_h
#define LightOptions_h

#include "Sun.h"
#include "Values.h"

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
  std::optional<SunAngles> Angles;  ///< of a sun that stands by them, instead
  std::optional<SunTime> Time;      ///< of a sun that stands by it, instead
  std::array<double, 3> FocalPoint; ///< of a spot
  double ConeAngle = 180.0;         ///< degrees, half the opening
  std::array<double, 3> Color = { 1.0, 1.0, 1.0 };
  double Intensity = 1.0;
  bool Casts = true;          ///< shadows, if there are any
  std::optional<double> Size; ///< a sun's angle in degrees, else a radius; none: as others are
  std::string Name;           ///< in reports; empty: by its number

  /// A sun by date, time and place that is below the horizon: it gives no light.
  bool IsNight() const { return this->Time && GetSunAngles(*this->Time).IsNight(); }

  /// Towards a sun in the world, where this axis (0, 1, 2 for x, y, z) points up.
  std::array<double, 3> GetDirection(int upAxis) const;
};

/// "KIND:NUMBERS[,NAME=VALUE]..."; throws UsageError.
LightChoice ParseLight(const std::string& word);

/// The parts of such a word.
struct LightWords
{
  std::string Kind;
  std::string Numbers;
  NamedWords Values;
};

/// Throws UsageError where there is no kind, or what is behind the numbers is no NAME=VALUE.
LightWords SplitLight(const std::string& word);
std::string WriteLight(const LightWords& words);

/// What --light says of such words, for people.
std::string DescribeLights();
}

#endif
