// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAnnotation.h"

#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <initializer_list>

namespace
{
constexpr std::size_t Short = 8;     // letters in a value
constexpr std::size_t ShortTick = 6; // longer texts share a factor
constexpr double Slack = 1e-6;       // share of a step by which a tick may be outside the range
constexpr double FewDecades = 1.5;   // logarithmic ranges below it have linear ticks
constexpr int PlainDecades[] = { -3, 4 }; // powers of ten written as 0.001 to 10000

const char* const Fonts[] = {
  "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",   // Debian, Ubuntu
  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", // Fedora
  "/usr/share/fonts/truetype/DejaVuSans.ttf",          // openSUSE
  "/usr/share/fonts/TTF/DejaVuSans.ttf",               // Arch
};

std::string FallbackFont;

std::string Write(double value, std::chars_format kind, int digits)
{
  std::array<char, 400> letters; // 309 digits before the point
  const std::to_chars_result end =
    std::to_chars(letters.begin(), letters.end(), value, kind, digits);
  return { letters.data(), end.ptr };
}

// With the fewest digits that are accurate to a few hundredths of the step between two values.
std::vector<std::string> Write(const std::vector<double>& values, std::chars_format kind)
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
  std::vector<std::string> texts;
  for (const double value : values)
  {
    texts.push_back(Write(value, kind, digits));
  }
  return texts;
}

std::size_t GetLength(const std::vector<std::string>& texts)
{
  std::size_t length = 0;
  for (const std::string& text : texts)
  {
    length = std::max(length, text.size());
  }
  return length;
}

bool HasFont()
{
  return !vtkRelievoAnnotation::GetFontFile().empty();
}

// With a minus sign as long as a plus.
std::string SetMinus(std::string text)
{
  if (HasFont() && !text.empty() && text[0] == '-')
  {
    text.replace(0, 1, "−");
  }
  return text;
}

std::string WritePower(int exponent)
{
  if (!HasFont())
  {
    return "1e" + std::to_string(exponent);
  }
  static const char* const raised[] = { "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹" };
  std::string text = "10";
  for (const char letter : std::to_string(exponent))
  {
    text += letter == '-' ? "⁻" : raised[letter - '0'];
  }
  return text;
}

// 1, 2 or 5 times a power of ten.
struct Step
{
  int Digit = 1;
  int Exponent = 0;

  // The least one that is not below a length.
  static Step RoundUp(double length)
  {
    Step step;
    step.Exponent = static_cast<int>(std::floor(std::log10(length)));
    const double share = length / std::pow(10.0, step.Exponent);
    step.Digit = share <= 1.0 + Slack ? 1 : share <= 2.0 + Slack ? 2 : 5;
    if (share > 5.0 + Slack)
    {
      step.Digit = 1;
      ++step.Exponent;
    }
    return step;
  }

  // Negative powers of ten are inexact doubles: a quotient of two exact doubles is rounded once.
  double GetMultiple(double count) const
  {
    return this->Exponent < 0 ? count * this->Digit / std::pow(10.0, -this->Exponent)
                              : count * this->Digit * std::pow(10.0, this->Exponent);
  }
};

void WriteTexts(vtkRelievoAnnotation::Ticks& ticks, int stepExponent)
{
  double largest = 0.0;
  for (const double value : ticks.Values)
  {
    largest = std::max(largest, std::abs(value));
  }
  std::vector<std::string> scaled;
  const int exponent = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  for (const double value : ticks.Values)
  {
    const double rounded = value == 0.0 ? 0.0 : value; // no negative zero
    ticks.Texts.push_back(Write(rounded, std::chars_format::fixed, std::max(0, -stepExponent)));
    scaled.push_back(Write(rounded / std::pow(10.0, exponent), std::chars_format::fixed,
      std::max(0, exponent - stepExponent)));
  }
  if (GetLength(ticks.Texts) > ShortTick && GetLength(scaled) < GetLength(ticks.Texts))
  {
    ticks.Texts = scaled;
    ticks.Factor = (HasFont() ? "×" : "") + WritePower(exponent);
  }
  for (std::string& text : ticks.Texts)
  {
    text = SetMinus(text);
  }
}

vtkRelievoAnnotation::Ticks MakeLinear(const double* range, int most)
{
  vtkRelievoAnnotation::Ticks ticks;
  const Step step = Step::RoundUp((range[1] - range[0]) / std::max(1, most - 1));
  const int parts = step.Digit == 2 ? 4 : 5;
  const double size = step.GetMultiple(1.0);
  const double last = std::floor(range[1] / size * parts + Slack);
  for (double i = std::ceil(range[0] / size * parts - Slack); i <= last; ++i)
  {
    const double count = i / parts;
    (std::fmod(i, parts) == 0.0 ? ticks.Values : ticks.Minor).push_back(step.GetMultiple(count));
  }
  WriteTexts(ticks, step.Exponent);
  return ticks;
}

vtkRelievoAnnotation::Ticks MakeLogarithmic(const double* range, int most)
{
  vtkRelievoAnnotation::Ticks ticks;
  const int first = static_cast<int>(std::ceil(std::log10(range[0]) - Slack));
  const int last = static_cast<int>(std::floor(std::log10(range[1]) + Slack));
  const int every = std::max(1, (last - first + most) / most);
  for (int decade = first - 1; decade <= last; ++decade)
  {
    const double value = std::pow(10.0, decade);
    if (decade >= first)
    {
      (decade % every == 0 ? ticks.Values : ticks.Minor).push_back(value);
    }
    for (int digit = 2; every == 1 && digit < 10; ++digit)
    {
      if (digit * value >= range[0] && digit * value <= range[1])
      {
        ticks.Minor.push_back(digit * value);
      }
    }
  }
  const bool plain = first >= PlainDecades[0] && last <= PlainDecades[1];
  for (const double value : ticks.Values)
  {
    const int decade = static_cast<int>(std::lround(std::log10(value)));
    ticks.Texts.push_back(
      plain ? Write(value, std::chars_format::fixed, std::max(0, -decade)) : WritePower(decade));
  }
  return ticks;
}
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkRelievoAnnotation::GetInk(vtkRenderer* renderer)
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
double vtkRelievoAnnotation::RoundDown(double length)
{
  Step step;
  step.Exponent = static_cast<int>(std::floor(std::log10(length)));
  const double share = length / std::pow(10.0, step.Exponent);
  step.Digit = share >= 5.0 ? 5 : share >= 2.0 ? 2 : 1;
  return step.GetMultiple(1.0);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoAnnotation::WriteValues(const std::vector<double>& values)
{
  const std::vector<std::string> fixed = Write(values, std::chars_format::fixed);
  const std::vector<std::string> scientific = Write(values, std::chars_format::scientific);
  return GetLength(fixed) <= std::max(Short, GetLength(scientific)) ? fixed : scientific;
}

//------------------------------------------------------------------------------
vtkRelievoAnnotation::Ticks vtkRelievoAnnotation::MakeTicks(const double* range, bool log, int most)
{
  return log && std::log10(range[1] / range[0]) >= FewDecades
    ? MakeLogarithmic(range, std::max(2, most))
    : MakeLinear(range, std::max(2, most));
}

//------------------------------------------------------------------------------
std::string vtkRelievoAnnotation::WriteValue(double value)
{
  std::string text = Write(value, std::chars_format::general, 5);
  const std::size_t power = text.find('e');
  if (power != std::string::npos && HasFont())
  {
    text = text.substr(0, power) + "×" + WritePower(std::stoi(text.substr(power + 1)));
  }
  return SetMinus(text);
}

//------------------------------------------------------------------------------
void vtkRelievoAnnotation::SetFallbackFont(const std::string& file)
{
  FallbackFont = file;
}

//------------------------------------------------------------------------------
const std::string& vtkRelievoAnnotation::GetFontFile()
{
  static const std::string found = [] {
    const char* given = std::getenv("RELIEVO_FONT");
    std::vector<std::string> files;
    if (given && *given)
    {
      files.emplace_back(given);
    }
    files.insert(files.end(), std::begin(Fonts), std::end(Fonts));
    files.push_back(FallbackFont);
    for (const std::string& file : files)
    {
      if (std::ifstream(file).good())
      {
        return file;
      }
    }
    return std::string();
  }();
  return found;
}

//------------------------------------------------------------------------------
void vtkRelievoAnnotation::SetFont(vtkTextProperty* text)
{
  if (HasFont())
  {
    text->SetFontFamily(VTK_FONT_FILE);
    text->SetFontFile(GetFontFile().c_str());
  }
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}
