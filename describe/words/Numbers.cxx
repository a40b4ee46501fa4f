// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include <charconv>
#include <cmath>

namespace words
{
//------------------------------------------------------------------------------
std::string WriteNumber(double value)
{
  char digits[64];
  const double size = std::abs(value);
  const std::chars_format format = value == 0.0 || (size >= 1e-6 && size < 1e15)
    ? std::chars_format::fixed
    : std::chars_format::general;
  const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), value, format);
  return std::string(digits, result.ptr);
}

//------------------------------------------------------------------------------
double RoundTo(double value, double step)
{
  if (!(step > 0.0) || !std::isfinite(step))
  {
    return value;
  }
  const double exponent = std::floor(std::log10(step));
  const double power = std::pow(10.0, std::abs(exponent)); // exact, unlike its inverse
  return exponent < 0.0 ? std::round(value * power) / power : std::round(value / power) * power;
}

//------------------------------------------------------------------------------
std::string WriteFileAndNumber(const std::string& file, double number)
{
  // A name that ends in a comma and digits would be parsed as a name with a number.
  const std::size_t comma = file.rfind(',');
  const bool plain = comma == std::string::npos ||
    file.find_first_not_of("0123456789.eE+-", comma + 1) != std::string::npos;
  return number == 0.0 && plain ? file : file + "," + WriteNumber(number);
}

//------------------------------------------------------------------------------
std::string WriteNumbers(const std::vector<double>& values)
{
  std::string words;
  for (const double value : values)
  {
    words += (words.empty() ? "" : ",") + WriteNumber(value);
  }
  return words;
}
}
