// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkyModel.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace relievo
{
//------------------------------------------------------------------------------
double GetAirMass(double sine)
{
  const double elevation = vtkMath::DegreesFromRadians(std::asin(std::clamp(sine, 0.0, 1.0)));
  return 1.0 / (std::max(sine, 0.0) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
}

//------------------------------------------------------------------------------
double GetExtraterrestrial(int dayOfYear)
{
  constexpr double mean = 1361.0;
  const double angle = 2.0 * vtkMath::Pi() * (dayOfYear - 1) / 365.0;
  return mean *
    (1.00011 + 0.034221 * std::cos(angle) + 0.00128 * std::sin(angle) +
      0.000719 * std::cos(2.0 * angle) + 7.7e-05 * std::sin(2.0 * angle));
}

//------------------------------------------------------------------------------
Sunlight GetClearSky(double sine, double extraterrestrial, double altitude, double turbidity)
{
  if (!(sine > 0.0))
  {
    return {};
  }
  // The pressure at the altitude, in the standard atmosphere, shortens the path.
  const double air = GetAirMass(sine) * std::pow(1.0 - 2.25577e-5 * altitude, 5.25588);
  const double low = std::exp(-altitude / 8000.0);
  const double high = std::exp(-altitude / 1250.0);
  // High above the sea the fits exceed the light outside of the atmosphere.
  const double global = extraterrestrial * sine *
    std::min(1.0,
      (5.09e-5 * altitude + 0.868) *
        std::exp(-(3.92e-5 * altitude + 0.0387) * air * (low + high * (turbidity - 1.0))));
  const double beam =
    extraterrestrial * (0.664 + 0.163 / low) * std::exp(-0.09 * air * (turbidity - 1.0));
  const double most =
    global * std::max(0.0, 1.0 - (0.1 - 0.2 * std::exp(-turbidity)) / (0.1 + 0.882 / low)) / sine;
  const double direct = std::min({ beam, most, extraterrestrial });
  return { direct, global - direct * sine };
}

//------------------------------------------------------------------------------
DiffuseShares GetPerezShares(double sine, double extraterrestrial, const Sunlight& light)
{
  if (!(light.Diffuse > 0.0))
  {
    return {};
  }
  // The upper ends of classes of clearness, and the coefficients of each (all sites, 1990).
  constexpr double clearness[] = { 1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2 };
  constexpr double coefficients[][6] = {
    { -0.008, 0.588, -0.062, -0.060, 0.072, -0.022 },
    { 0.130, 0.683, -0.151, -0.019, 0.066, -0.029 },
    { 0.330, 0.487, -0.221, 0.055, -0.064, -0.026 },
    { 0.568, 0.187, -0.295, 0.109, -0.152, -0.014 },
    { 0.873, -0.392, -0.362, 0.226, -0.462, 0.001 },
    { 1.132, -1.237, -0.412, 0.288, -0.823, 0.056 },
    { 1.060, -1.600, -0.359, 0.264, -1.127, 0.131 },
    { 0.678, -0.327, -0.250, 0.156, -1.377, 0.251 },
  };
  const double zenith = std::acos(std::clamp(sine, 0.0, 1.0));
  const double scaled = 1.041 * zenith * zenith * zenith;
  const double clear = ((light.Diffuse + light.Direct) / light.Diffuse + scaled) / (1.0 + scaled);
  const auto row = static_cast<std::size_t>(
    std::upper_bound(std::begin(clearness), std::end(clearness), clear) - std::begin(clearness));
  const double(&f)[6] = coefficients[row];
  // At most 1, that of a sky which has all light from outside of the atmosphere: data that are
  // spread over minutes after a sunrise can exceed it.
  const double brightness = std::min(1.0, light.Diffuse * GetAirMass(sine) / extraterrestrial);
  return { std::clamp(f[0] + f[1] * brightness + f[2] * zenith, 0.0, 1.0),
    f[3] + f[4] * brightness + f[5] * zenith };
}
}
