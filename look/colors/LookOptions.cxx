// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LookOptions.h"

#include "Colormaps.h"
#include "Errors.h"
#include "Numbers.h"
#include "Values.h"

#include "vtkRelievoColorWords.h"

#include <algorithm>
#include <limits>

namespace look
{
namespace
{
constexpr std::size_t LongestUnit = 32; // bytes
}

//------------------------------------------------------------------------------
Color ParseColor(const std::string& option, const std::string& word)
{
  Color color;
  if (relievo::ReadColor(word, color.data()))
  {
    return color;
  }
  const std::vector<std::string> parts = Split(word, '/');
  const char* const form = "R/G/B from 0 to 1, #rrggbb, or a colour's name";
  if (parts.size() != 3)
  {
    RefuseValue(option, word, form);
  }
  const std::vector<double> numbers = ParseNumbers(option, Join(parts, ","), 3, form);
  if (std::any_of(numbers.begin(), numbers.end(), [](double n) { return n < 0.0 || n > 1.0; }))
  {
    RefuseValue(option, word, form);
  }
  std::copy(numbers.begin(), numbers.end(), color.begin());
  return color;
}

//------------------------------------------------------------------------------
void TakeColorBy(LookChoice& look, const std::string& word)
{
  look.ColorBy = look.ColorByAsGiven = word;
  // An array's name may contain commas.
  const std::string::size_type comma = word.rfind(',');
  const std::string last = comma == std::string::npos ? "" : word.substr(comma + 1);
  look.Magnitude = last == "magnitude";
  const bool number =
    !last.empty() && last.size() < 7 && last.find_first_not_of("0123456789") == std::string::npos;
  if (number)
  {
    look.Component = std::stoi(last);
  }
  if (number || look.Magnitude)
  {
    look.ColorBy.erase(comma);
  }
  if (look.ColorBy.empty())
  {
    RefuseValue("--color-by", word, "NAME[,COMPONENT]");
  }
}

//------------------------------------------------------------------------------
void TakeRange(LookChoice& look, const std::string& word)
{
  look.Symmetric = word == "symmetric";
  if (look.Symmetric)
  {
    look.Range.reset();
    return;
  }
  const std::vector<double> n = ParseNumbers("--range", word, 2, "MIN,MAX or symmetric");
  if (n[0] >= n[1])
  {
    RefuseValue("--range", word, "MIN,MAX with MIN < MAX");
  }
  look.Range = { n[0], n[1] };
}

//------------------------------------------------------------------------------
void TakeColormap(LookChoice& look, const std::string& word)
{
  CheckColormap(word);
  look.Colormap = word;
}

//------------------------------------------------------------------------------
void TakeBar(LookChoice& look, const std::string& word)
{
  static const std::vector<std::string> places = { "right", "left", "bottom", "top" };
  const char* const form = "right, left, bottom or top, then optionally ,title=TEXT and ,unit=UNIT";
  BarChoice bar;
  // Texts may contain commas: a text ends where the next part begins.
  const std::size_t comma = std::min(word.find(','), word.size());
  const auto place = std::find(places.begin(), places.end(), word.substr(0, comma));
  const std::string rest = word.substr(comma);
  const std::size_t unit = std::min(rest.rfind(",unit="), rest.size());
  const std::string title = rest.substr(0, unit);
  const std::string titled = ",title=";
  if (place == places.end() || !(title.empty() || title.rfind(titled, 0) == 0))
  {
    RefuseValue("--bar", word, form);
  }
  bar.Place = static_cast<int>(place - places.begin());
  if (!title.empty())
  {
    bar.Title = title.substr(titled.size());
  }
  bar.Unit = unit < rest.size() ? rest.substr(unit + std::string(",unit=").size()) : "";
  look.Bar = bar;
  look.ScalarBar = true;
}

//------------------------------------------------------------------------------
void TakeColor(LookChoice& look, const std::string& word)
{
  look.Solid = ParseColor("--color", word);
}

//------------------------------------------------------------------------------
void TakeOpacityCurve(LookChoice& look, const std::string& word)
{
  const char* const form = "VALUE/OPACITY,VALUE/OPACITY,... with increasing values and opacities "
                           "from 0 to 1, at least two";
  std::vector<std::array<double, 2>> curve;
  for (const std::string& part : Split(word, ','))
  {
    const std::vector<std::string> pair = Split(part, '/');
    if (pair.size() != 2)
    {
      RefuseValue("--opacity-curve", word, form);
    }
    const std::vector<double> n = ParseNumbers("--opacity-curve", Join(pair, ","), 2, form);
    if (n[1] < 0.0 || n[1] > 1.0 || (!curve.empty() && n[0] <= curve.back()[0]))
    {
      RefuseValue("--opacity-curve", word, form);
    }
    curve.push_back({ n[0], n[1] });
  }
  if (curve.size() < 2)
  {
    RefuseValue("--opacity-curve", word, form);
  }
  look.OpacityCurve = curve;
}

//------------------------------------------------------------------------------
std::string WriteOpacityCurve(const std::vector<std::array<double, 2>>& curve)
{
  std::vector<std::string> words;
  for (const std::array<double, 2>& point : curve)
  {
    words.push_back(WriteNumber(point[0]) + "/" + WriteNumber(point[1]));
  }
  return Join(words, ",");
}

//------------------------------------------------------------------------------
void TakeScaleBar(LookChoice& look, const std::string& word)
{
  const std::string mark = ",length=";
  const std::string unit = word.substr(0, word.find(','));
  const std::string rest = word.substr(unit.size());
  const auto isControl = [](char letter) { return static_cast<unsigned char>(letter) < ' '; };
  if (unit.empty() || unit.size() > LongestUnit ||
    std::any_of(unit.begin(), unit.end(), isControl) || !(rest.empty() || rest.rfind(mark, 0) == 0))
  {
    RefuseValue("--scale-bar", word,
      "a unit in a few letters, such as mm, or none, optionally followed by ,length=LENGTH");
  }
  look.ScaleBar = unit == "none" ? "" : unit;
  look.ScaleBarLength = rest.empty()
    ? 0.0
    : ParseNumberBetween("--scale-bar length", rest.substr(mark.size()), 0.0,
        std::numeric_limits<double>::infinity());
}

//------------------------------------------------------------------------------
void TakeBackground(LookChoice& look, const std::string& word)
{
  const std::vector<std::string> parts = Split(word, ',');
  if (parts.size() > 2)
  {
    RefuseValue("--background", word, "COLOR, or COLOR,COLOR for the bottom and the top");
  }
  look.Background.clear();
  for (const std::string& part : parts)
  {
    look.Background.push_back(ParseColor("--background", part));
  }
}

//------------------------------------------------------------------------------
void CheckLookOptions(const LookChoice& look, const GivenWords& given)
{
  if (Colormap::Parse(look.Colormap).Log &&
    (look.Symmetric || (look.Range && (*look.Range)[0] <= 0.0)))
  {
    throw UsageError(std::string("--colormap log: logarithms need positive values; ") +
      (look.Symmetric ? "give no --range symmetric as well"
                      : "give a --range that begins above 0"));
  }
  if (look.Solid)
  {
    for (const char* option : { "--color-by", "--colormap", "--range", "--scalar-bar", "--bar" })
    {
      if (given.count(option))
      {
        throw UsageError(std::string(option) +
          " and --color: colours follow values, or are one for all; give one of them");
      }
    }
  }
}
}
