// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A value of points, as options of lamps, fog and markers have it: one for all, or the name of an
 * array.
 */
#ifndef PointValue_h
#define PointValue_h

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scene
{
/// A number for all points, or the name of a point array.
struct PointValue
{
  std::optional<double> Number;
  std::string Array;
};

/// A linear colour for all points, or the name of a point array.
struct ColorValue
{
  std::optional<std::array<double, 3>> Color;
  std::string Array;
};

/// A number of `least` or more, or else a name. Throws UsageError.
PointValue ParsePointValue(const std::string& option, const std::string& word, double least);

/// R/G/B, or else a name. Throws UsageError.
ColorValue ParseColorValue(const std::string& option, const std::string& word);

/// Three numbers, A/B/C. Throws UsageError.
std::array<double, 3> ParseThree(const std::string& option, const std::string& word);

/// FILE[,NAME=VALUE]...: the file, and the names with their values, each once; a comma of one
/// is written \,. Throws UsageError that shows the form.
std::string ParseFileAndValues(const std::string& option, const std::string& word,
  const std::string& form, std::vector<std::pair<std::string, std::string>>& values);

/// The word that ParseFileAndValues reads so.
std::string WriteFileAndValues(
  const std::string& file, const std::vector<std::pair<std::string, std::string>>& values);
}

#endif
