// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NewLights.h"

#include "Document.h"
#include "FittedView.h"
#include "LightOptions.h"

#include <array>
#include <cmath>

namespace viewer
{
namespace
{
// From the upper left in front of the fitted scene, or from the other side if there are lights; in
// radii of the scene's bounding sphere.
constexpr std::array<double, 3> Towards[] = { { -0.6, 1.0, 0.7 }, { 1.0, 0.9, -0.2 } };
constexpr double Distance = 2.5;
constexpr double Cone = 28.0; // degrees; the sphere spans 23.6 degrees each way from there

// Keeps words short.
double Round(double value, double size)
{
  return words::RoundTo(value, 0.01 * size);
}
}

//------------------------------------------------------------------------------
std::string WriteNewLight(const Document& document, const std::string& kind)
{
  const std::size_t others = document.Get().GetAll("--light").size();
  const std::array<double, 6>& b = document.GetFacts().Bounds;
  const double radius = 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  const double size = radius > 0.0 ? radius : 1.0;
  const std::array<double, 3> towards =
    look::FittedView(document.GetUpAxis()).ToWorld(Towards[others % 2]);
  std::vector<double> position, middle;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double center = 0.5 * (b[2 * i] + b[2 * i + 1]);
    middle.push_back(Round(center, size));
    position.push_back(Round(center + Distance * size * towards[i], size));
  }
  if (kind == "sun")
  {
    const look::SunAngles angles = look::GetSunAngles(towards, document.GetUpAxis());
    position = { words::RoundTo(angles.Azimuth, 1.0), words::RoundTo(angles.Elevation, 1.0) };
  }
  if (kind == "spot")
  {
    position.insert(position.end(), middle.begin(), middle.end());
    position.push_back(Cone);
  }
  look::LightWords words = { kind, words::WriteNumbers(position), {} };
  if (others > 0)
  {
    words.Values.emplace_back("intensity", "0.3"); // together they would overexpose the picture
  }
  return look::WriteLight(words);
}
}
