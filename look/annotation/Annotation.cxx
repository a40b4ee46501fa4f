// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Annotation.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace scene
{
namespace
{
constexpr std::size_t Short = 8; // letters in a value

WrittenValues Write(const std::vector<double>& values, std::chars_format kind, int digits)
{
  WrittenValues written;
  written.Format = "%." + std::to_string(digits) + (kind == std::chars_format::fixed ? "f" : "e");
  for (const double value : values)
  {
    std::array<char, 400> letters; // 309 digits before the point
    const std::to_chars_result end =
      std::to_chars(letters.begin(), letters.end(), value, kind, digits);
    written.Texts.emplace_back(letters.data(), end.ptr);
  }
  return written;
}

// With the fewest digits that are accurate to a few hundredths of the step between two values.
WrittenValues Write(const std::vector<double>& values, std::chars_format kind)
{
  const double step = std::abs(values[1] - values[0]);
  const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
  const double tolerance = step > 0.0 ? 0.03 * step : 0.001 * largest;
  int digits = 0;
  const auto isRight = [&](double value) {
    const double exponent = kind == std::chars_format::fixed || value == 0.0
      ? 0.0
      : std::floor(std::log10(std::abs(value)));
    const double scaled = value / std::pow(10.0, exponent - digits);
    return std::abs(scaled - std::round(scaled)) <= tolerance / std::pow(10.0, exponent - digits);
  };
  while (digits < 17 && !std::all_of(values.begin(), values.end(), isRight))
  {
    ++digits;
  }
  return Write(values, kind, digits);
}

std::size_t GetLength(const WrittenValues& written)
{
  std::size_t length = 0;
  for (const std::string& text : written.Texts)
  {
    length = std::max(length, text.size());
  }
  return length;
}
}

//------------------------------------------------------------------------------
std::array<double, 3> GetInk(vtkRenderer* renderer)
{
  const auto getLuma = [](const double* rgb) {
    return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
  };
  const double bottom = getLuma(renderer->GetBackground());
  const double luma = renderer->GetGradientBackground()
    ? (bottom + getLuma(renderer->GetBackground2())) / 2.0
    : bottom;
  const double ink = luma > 0.5 ? 0.0 : 1.0;
  return { ink, ink, ink };
}

//------------------------------------------------------------------------------
double RoundDown(double length)
{
  const double exponent = std::floor(std::log10(length));
  const double share = length / std::pow(10.0, exponent);
  const double digit = share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0;
  // Negative powers of ten are inexact doubles: a quotient of two exact doubles is rounded once.
  return exponent < 0.0 ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent);
}

//------------------------------------------------------------------------------
WrittenValues WriteValues(const std::vector<double>& values)
{
  const WrittenValues fixed = Write(values, std::chars_format::fixed);
  const WrittenValues scientific = Write(values, std::chars_format::scientific);
  return GetLength(fixed) <= std::max(Short, GetLength(scientific)) ? fixed : scientific;
}
}
