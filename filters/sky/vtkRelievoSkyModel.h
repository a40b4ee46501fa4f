// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Published models of sunlight: the light of a sky without clouds, and how the diffuse part is
// spread over the sky.
#ifndef vtkRelievoSkyModel_h
#define vtkRelievoSkyModel_h

#include "vtkRelievoFiltersModule.h" // for the export macro

namespace relievo
{
// Watts per square metre on a plane that faces the sun, and from the sky on level ground.
struct Sunlight
{
  double Direct = 0.0;
  double Diffuse = 0.0;
};

// The path through the air relative to that of a sun at the zenith; `sine` is that of the sun's
// elevation (F. Kasten, A. T. Young 1989).
VTKRELIEVOFILTERS_EXPORT double GetAirMass(double sine);

// Watts per square metre outside of the atmosphere on a day of the year, from 1 (J. W. Spencer
// 1971, with a mean of 1361).
VTKRELIEVOFILTERS_EXPORT double GetExtraterrestrial(int dayOfYear);

// A sky without clouds (P. Ineichen, R. Perez, A new airmass independent formulation for the Linke
// turbidity coefficient, 2002): altitude in metres, Linke's turbidity.
VTKRELIEVOFILTERS_EXPORT Sunlight GetClearSky(
  double sine, double extraterrestrial, double altitude, double turbidity);

// Shares of the diffuse light that come from around the sun and, beside a uniform sky, from the
// horizon; the latter may be negative (R. Perez et al., Modeling daylight availability and
// irradiance components from direct and global irradiance, 1990).
struct DiffuseShares
{
  double Sun = 0.0;
  double Horizon = 0.0;
};
VTKRELIEVOFILTERS_EXPORT DiffuseShares GetPerezShares(
  double sine, double extraterrestrial, const Sunlight& light);
}

#endif
