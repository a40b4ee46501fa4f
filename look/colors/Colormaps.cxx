// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormaps.h"

#include "Errors.h"
#include "Numbers.h"
#include "Values.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoColormaps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace look
{
namespace
{
// With this setting VTK's mappers and bars use logarithms, too.
class LogColormap : public vtkColorTransferFunction
{
public:
  static LogColormap* New();
  vtkTypeMacro(LogColormap, vtkColorTransferFunction);
  int UsingLogScale() override { return 1; }
};
vtkStandardNewMacro(LogColormap);

constexpr int MostSteps = 256;
constexpr int LogPoints = 256; // points of a logarithmic map
constexpr double Hair = 1e-7;  // gives a value at an edge the upper colour

const char* const ColormapForm = "MAP[:reversed][:log][:steps=N][:nan=COLOR]";
const char* const OwnMapForm = ", or colours between commas, such as black,#ff8000,white or "
                               "black,0.3=#ff8000,white";

// Evenly spaced over a range.
void FillMap(vtkColorTransferFunction* map, const Colormap& words, double low, double high)
{
  const double from = words.Reversed ? high : low;
  const double to = words.Reversed ? low : high;
  vtkRelievoColormaps::Fill(map, words.Map, from, to);
  const std::vector<ColorStop> stops = ParseStops(words.Map);
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    // Spaces stops at one place, an edge, by a hair each, because VTK keeps one point per place.
    std::size_t later = 0;
    while (i + later + 1 < stops.size() && stops[i + later + 1].Place == stops[i].Place)
    {
      ++later;
    }
    const double place = stops[i].Place - static_cast<double>(later) * Hair;
    const Color& shown = stops[i].Shown;
    map->AddRGBPoint(from + place * (to - from), shown[0], shown[1], shown[2]);
  }
  if (!stops.empty()) // stops may end within the range
  {
    const Color& first = stops.front().Shown;
    const Color& last = stops.back().Shown;
    if (stops.front().Place > 0.0)
    {
      map->AddRGBPoint(from, first[0], first[1], first[2]);
    }
    if (stops.back().Place < 1.0)
    {
      map->AddRGBPoint(to, last[0], last[1], last[2]);
    }
  }
}

double GetValueAt(double share, double from, double to, bool log)
{
  return log ? from * std::pow(to / from, share) : from + share * (to - from);
}

std::string WriteHexadecimal(const Color& color)
{
  std::array<char, 8> letters;
  std::snprintf(letters.data(), letters.size(), "#%02x%02x%02x",
    static_cast<unsigned int>(std::lround(255.0 * color[0])),
    static_cast<unsigned int>(std::lround(255.0 * color[1])),
    static_cast<unsigned int>(std::lround(255.0 * color[2])));
  return letters.data();
}

// Spaces stops without a place (negative) evenly between their neighbours.
void Spread(std::vector<ColorStop>& stops)
{
  stops.front().Place = stops.front().Place < 0.0 ? 0.0 : stops.front().Place;
  stops.back().Place = stops.back().Place < 0.0 ? 1.0 : stops.back().Place;
  for (std::size_t i = 1; i + 1 < stops.size(); ++i)
  {
    std::size_t next = i;
    while (stops[next].Place < 0.0)
    {
      ++next;
    }
    const double last = stops[i - 1].Place;
    stops[i].Place = next == i
      ? stops[i].Place
      : last + (stops[next].Place - last) / static_cast<double>(next - i + 1);
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetColormapNames()
{
  return vtkRelievoColormaps::GetNames();
}

//------------------------------------------------------------------------------
Colormap Colormap::Parse(const std::string& word)
{
  const std::vector<std::string> parts = Split(word, ':');
  Colormap map;
  map.Map = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    const std::string name = parts[i].substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : parts[i].substr(equals + 1);
    if (parts[i] == "reversed")
    {
      map.Reversed = true;
    }
    else if (parts[i] == "log")
    {
      map.Log = true;
    }
    else if (name == "steps")
    {
      const double steps = ParseNumbers("--colormap", value, 1, "steps=N")[0];
      if (steps != std::floor(steps) || steps < 2.0 || steps > MostSteps)
      {
        RefuseValue("--colormap steps", value, "a whole number from 2 to 256");
      }
      map.Steps = static_cast<int>(steps);
    }
    else if (name == "nan")
    {
      ParseColor("--colormap nan", value);
      map.Nan = value;
    }
    else
    {
      RefuseValue("--colormap", word, ColormapForm);
    }
  }
  return map;
}

//------------------------------------------------------------------------------
std::string Colormap::Write() const
{
  return this->Map + (this->Reversed ? ":reversed" : "") + (this->Log ? ":log" : "") +
    (this->Steps > 0 ? ":steps=" + std::to_string(this->Steps) : "") +
    (this->Nan.empty() ? "" : ":nan=" + this->Nan);
}

//------------------------------------------------------------------------------
std::vector<ColorStop> ParseStops(const std::string& map)
{
  std::vector<ColorStop> stops;
  if (map.find(',') == std::string::npos)
  {
    return stops;
  }
  double least = 0.0;
  for (const std::string& part : Split(map, ','))
  {
    const std::size_t equals = part.find('=');
    ColorStop stop;
    stop.Place = -1.0;
    if (equals != std::string::npos)
    {
      const std::string place = part.substr(0, equals);
      stop.Place = ParseNumbers("--colormap", place, 1, "a share of the range")[0];
      if (!(stop.Place >= least && stop.Place <= 1.0))
      {
        RefuseValue(
          "--colormap", part, "a place from 0 to 1, no less than that of the colour before");
      }
      least = stop.Place;
    }
    stop.Shown =
      ParseColor("--colormap", equals == std::string::npos ? part : part.substr(equals + 1));
    stops.push_back(stop);
  }
  Spread(stops);
  return stops;
}

//------------------------------------------------------------------------------
std::string WriteStops(std::vector<ColorStop> stops)
{
  std::stable_sort(stops.begin(), stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Place < b.Place; });
  const double intervals = static_cast<double>(stops.size()) - 1.0;
  bool even = true;
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    even = even && std::abs(stops[i].Place - static_cast<double>(i) / intervals) < 1e-9;
  }
  std::string words;
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    const double place = stops[i].Place;
    const bool end = (i == 0 && place == 0.0) || (i + 1 == stops.size() && place == 1.0);
    words += (i == 0 ? "" : ",") + (even || end ? "" : WriteNumber(place) + "=") +
      WriteHexadecimal(stops[i].Shown);
  }
  return words;
}

//------------------------------------------------------------------------------
void CheckColormap(const std::string& word)
{
  const Colormap map = Colormap::Parse(word);
  const std::vector<std::string> names = GetColormapNames();
  if (map.Map.find(',') == std::string::npos &&
    std::find(names.begin(), names.end(), map.Map) == names.end())
  {
    RefuseValue("--colormap", word, "one of " + Join(names, ", ") + OwnMapForm);
  }
  ParseStops(map.Map);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& word, const std::array<double, 2>& range, bool sampled)
{
  const Colormap words = Colormap::Parse(word);
  vtkSmartPointer<vtkColorTransferFunction> map;
  if (words.Log && !sampled)
  {
    map = vtkSmartPointer<LogColormap>::New();
    map->SetScaleToLog10();
  }
  else
  {
    map = vtkSmartPointer<vtkColorTransferFunction>::New();
  }
  const Color nan =
    words.Nan.empty() ? Color{ 0.5, 0.5, 0.5 } : ParseColor("--colormap nan", words.Nan);
  map->SetNanColor(nan[0], nan[1], nan[2]);
  const double from = range[0];
  const double to = range[1] > range[0] ? range[1] : range[0] + 1.0;
  if (!words.Log && words.Steps == 0)
  {
    FillMap(map, words, from, to);
    map->Build();
    return map;
  }
  vtkNew<vtkColorTransferFunction> whole;
  FillMap(whole, words, 0.0, 1.0);
  const int count = words.Steps > 0 ? words.Steps : LogPoints;
  for (int i = 0; i < count; ++i)
  {
    double rgb[3];
    const double share = static_cast<double>(i) / (count - 1);
    whole->GetColor(share, rgb);
    if (words.Steps == 0)
    {
      map->AddRGBPoint(GetValueAt(share, from, to, words.Log), rgb[0], rgb[1], rgb[2]);
      continue;
    }
    // Between two steps' middles the colour jumps halfway.
    constexpr double Halfway = 0.5;
    constexpr double AtOnce = 1.0;
    const double middle = (i + 0.5) / count - Hair;
    if (i == 0)
    {
      map->AddRGBPoint(from, rgb[0], rgb[1], rgb[2], Halfway, AtOnce);
    }
    map->AddRGBPoint(
      GetValueAt(middle, from, to, words.Log), rgb[0], rgb[1], rgb[2], Halfway, AtOnce);
    if (i + 1 == count)
    {
      map->AddRGBPoint(to, rgb[0], rgb[1], rgb[2], Halfway, AtOnce);
    }
  }
  map->Build();
  return map;
}
}
