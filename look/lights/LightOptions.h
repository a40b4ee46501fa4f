// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --light: a light of the scene in words.
 */
#ifndef LightOptions_h
#define LightOptions_h

#include "LookNames.h"
#include "Sun.h"
#include "Values.h"

#include <array>
#include <optional>
#include <string>

namespace look
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
  bool InView = false; ///< the direction is right, up and to the camera before it is fitted
  std::optional<SunAngles> Angles;  ///< of a sun given by angles
  std::optional<SunTime> Time;      ///< of a sun given by time
  std::array<double, 3> FocalPoint; ///< of a spot
  double ConeAngle = 180.0;         ///< half the opening, degrees
  std::array<double, 3> Color = { 1.0, 1.0, 1.0 };
  double Intensity = 1.0;
  bool Fills = false;         ///< a fill light: part of the light of all surroundings
  bool Casts = true;          ///< whether it casts shadows, if there are any
  std::optional<double> Size; ///< a sun's angle in degrees, else a radius; none: the default
  std::string Name;           ///< in reports; empty: its number

  /// The angles of a sun given by them, or by date, time and place; none: another light.
  std::optional<SunAngles> GetAngles() const
  {
    return this->Time ? GetSunAngles(*this->Time) : this->Angles;
  }

  /// Whether a sun by date, time and place is below the horizon and gives no light. One by angles
  /// lights from beneath.
  bool IsNight() const { return this->Time && GetSunAngles(*this->Time).IsNight(); }

  /// Unit direction towards a sun in the world, where `upAxis` (0, 1, 2 for x, y, z) points up.
  std::array<double, 3> GetDirection(int upAxis) const;
};

/// Parses "KIND:NUMBERS[,NAME=VALUE]..."; throws UsageError.
LightChoice ParseLight(const std::string& word);

/// The parts of such a word.
struct LightWords
{
  std::string Kind;
  std::string Numbers;
  NamedWords Values;
};

/// Throws UsageError if the kind is missing, or if a part after the numbers is no NAME=VALUE.
LightWords SplitLight(const std::string& word);
std::string WriteLight(const LightWords& words);

/// The help of --light.
std::string DescribeLights();
}

#endif
