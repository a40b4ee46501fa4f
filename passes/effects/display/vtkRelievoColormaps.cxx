// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColormaps.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int FormulaSteps = 64; // of maps defined by a formula
constexpr double Hair = 1e-7;    // between two colours that change at once

using Map = vtkColorTransferFunction;

constexpr double Pi = 3.14159265358979323846;

// A colour in OKLab (B. Ottosson, A perceptual color space for image processing, 2020): lightness,
// chroma and hue, degrees.
struct Lch
{
  double Lightness, Chroma, Hue;
};

// Linear light; out of 0 to 1 where a display cannot show the colour.
glm::dvec3 ToLinear(const Lch& color)
{
  const double a = color.Chroma * std::cos(color.Hue * Pi / 180.0);
  const double b = color.Chroma * std::sin(color.Hue * Pi / 180.0);
  const double l = std::pow(color.Lightness + 0.3963377774 * a + 0.2158037573 * b, 3.0);
  const double m = std::pow(color.Lightness - 0.1055613458 * a - 0.0638541728 * b, 3.0);
  const double s = std::pow(color.Lightness - 0.0894841775 * a - 1.2914855480 * b, 3.0);
  return { 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s };
}

// A colour that displays cannot show gets less chroma; its lightness and hue stay.
glm::dvec3 ToDisplay(Lch color)
{
  const auto isShown = [](const glm::dvec3& rgb) {
    return std::min({ rgb.x, rgb.y, rgb.z }) >= 0.0 && std::max({ rgb.x, rgb.y, rgb.z }) <= 1.0;
  };
  if (!isShown(ToLinear(color)))
  {
    double shown = 0.0;
    double wanted = color.Chroma;
    for (int i = 0; i < 30; ++i)
    {
      color.Chroma = 0.5 * (shown + wanted);
      (isShown(ToLinear(color)) ? shown : wanted) = color.Chroma;
    }
    color.Chroma = shown;
  }
  return relievo::f64::relievoSrgbColorFromLinear(
    glm::clamp(ToLinear(color), glm::dvec3(0.0), glm::dvec3(1.0)));
}

void FillAlong(Map* map, double low, double high, Lch (*at)(double share))
{
  for (int i = 0; i <= FormulaSteps; ++i)
  {
    const double share = double(i) / FormulaSteps;
    const glm::dvec3 color = ToDisplay(at(share));
    map->AddRGBPoint(low + share * (high - low), color.x, color.y, color.z);
  }
}

// From one hue over a light neutral middle to another; lightness is symmetric.
Lch Diverge(double share, double dark, double firstHue, double lastHue)
{
  constexpr double light = 0.96;
  constexpr double chroma = 0.135;
  const double side = std::abs(2.0 * share - 1.0);
  return { light - (light - dark) * side, chroma * side, share < 0.5 ? firstHue : lastHue };
}

struct NamedMap
{
  const char* Name;
  void (*Fill)(Map* map, double low, double high);
};

const NamedMap NamedMaps[] = {
  // Perceptually uniform, also for colour-blind readers: S. van der Walt, N. Smith, 2015.
  { "viridis",
    [](Map* map, double low, double high) {
      for (int i = 0; i <= FormulaSteps; ++i)
      {
        const double share = double(i) / FormulaSteps;
        const glm::dvec3 color = relievo::f64::relievoColormap(share);
        map->AddRGBPoint(low + share * (high - low), color.x, color.y, color.z);
      }
    } },
  // Diverging from the middle: K. Moreland, Diverging Color Maps for Scientific Visualization,
  // 2009.
  { "cool-warm",
    [](Map* map, double low, double high) {
      map->SetColorSpaceToDiverging();
      map->AddRGBPoint(low, 0.230, 0.299, 0.754);
      map->AddRGBPoint(high, 0.706, 0.016, 0.150);
    } },
  { "grey",
    [](Map* map, double low, double high) {
      map->AddRGBPoint(low, 0.0, 0.0, 0.0);
      map->AddRGBPoint(high, 1.0, 1.0, 1.0);
    } },
  // Black, red, yellow, white: the colours of a heated body.
  { "hot",
    [](Map* map, double low, double high) {
      const double width = high - low;
      map->AddRGBPoint(low, 0.0, 0.0, 0.0);
      map->AddRGBPoint(low + 0.4 * width, 0.9, 0.0, 0.0);
      map->AddRGBPoint(low + 0.8 * width, 0.9, 0.9, 0.0);
      map->AddRGBPoint(high, 1.0, 1.0, 1.0);
    } },
  // Blue to red by hue, the older default of many tools.
  { "rainbow",
    [](Map* map, double low, double high) {
      map->SetColorSpaceToHSV();
      map->HSVWrapOff();
      map->AddHSVPoint(low, 2.0 / 3.0, 1.0, 1.0);
      map->AddHSVPoint(high, 0.0, 1.0, 1.0);
    } },
  // The maps below are made in OKLab. Sequential: lightness grows evenly.
  { "ember",
    [](Map* map, double low, double high) {
      FillAlong(map, low, high, [](double share) {
        return Lch{ 0.18 + 0.78 * share, 0.03 + 0.155 * std::sin(Pi * (0.02 + 0.93 * share)),
          300.0 + 165.0 * share };
      });
    } },
  { "ocean",
    [](Map* map, double low, double high) {
      FillAlong(map, low, high, [](double share) {
        return Lch{ 0.2 + 0.75 * share, 0.03 + 0.068 * std::sin(Pi * share),
          275.0 - 120.0 * share };
      });
    } },
  { "blue-orange",
    [](Map* map, double low, double high) {
      FillAlong(map, low, high, [](double share) { return Diverge(share, 0.55, 255.0, 50.0); });
    } },
  { "green-purple",
    [](Map* map, double low, double high) {
      FillAlong(map, low, high, [](double share) { return Diverge(share, 0.5, 150.0, 320.0); });
    } },
  // Cyclic, of one lightness and chroma: for angles and phases.
  { "phase",
    [](Map* map, double low, double high) {
      FillAlong(map, low, high, [](double share) {
        return Lch{ 0.74, 0.125, 20.0 + 360.0 * share };
      });
    } },
  // Ten colours for labels; neighbours differ in hue and lightness.
  { "categories",
    [](Map* map, double low, double high) {
      constexpr int count = 10;
      constexpr double turn = 36.0; // degrees
      constexpr double lightness[] = { 0.55, 0.84, 0.41, 0.72 };
      constexpr double halfway = 0.5;
      constexpr double atOnce = 1.0; // colours change at once between two points
      for (int i = 0; i < count; ++i)
      {
        const glm::dvec3 color = ToDisplay({ lightness[i % 4], 0.16, 105.0 + turn * i });
        const double ends[] = { double(i) / count, (i + 1.0) / count - (i + 1 < count ? Hair : 0) };
        for (const double end : ends)
        {
          map->AddRGBPoint(low + end * (high - low), color.x, color.y, color.z, halfway, atOnce);
        }
      }
    } },
};
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkRelievoColormaps::GetNames()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedMap& each : NamedMaps)
    {
      all.emplace_back(each.Name);
    }
    return all;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkRelievoColormaps::Fill(
  vtkColorTransferFunction* map, const std::string& name, double low, double high)
{
  for (const NamedMap& each : NamedMaps)
  {
    if (name == each.Name)
    {
      each.Fill(map, low, high);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 3>> vtkRelievoColormaps::Sample(
  const std::string& name, bool reversed, int count)
{
  vtkNew<vtkColorTransferFunction> map;
  vtkRelievoColormaps::Fill(map, name, reversed ? 1.0 : 0.0, reversed ? 0.0 : 1.0);
  std::vector<std::array<float, 3>> colors(static_cast<std::size_t>(count));
  map->GetTable(0.0, 1.0, count, colors[0].data());
  return colors;
}
