// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What points are as lamps, fog or markers: the values behind the file of such an option.
 */
#ifndef PointsValues_h
#define PointsValues_h

#include <string>
#include <vector>

namespace viewer
{
struct PointsValue
{
  enum Kind
  {
    Number, ///< or an array's name, or one of the choices
    Color,  ///< R/G/B, linear, or an array's name
    Three,  ///< A/B/C
    Choice  ///< one of the choices; the first is meant where nothing is said
  };
  std::string Name, Label;
  Kind Is;
  std::string Standard; ///< what is meant where nothing is said
  std::string Help;
  std::vector<std::string> Choices;
};

std::vector<PointsValue> GetPointsValues(const std::string& stage);
}

#endif
