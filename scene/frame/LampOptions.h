// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The option --lamps: a file of points, and what they are as lamps.
 */
#ifndef LampOptions_h
#define LampOptions_h

#include "PointValue.h"

#include <array>
#include <optional>
#include <string>

namespace scene
{
enum class Falloff
{
  Linear,
  InverseSquare,
  VTK
};

struct LampChoice
{
  std::string File;
  PointValue Radius;
  PointValue Intensity;
  ColorValue Color;
  Falloff Kind = Falloff::Linear;
  std::optional<std::array<double, 3>> Attenuation; ///< of Falloff::VTK
  PointValue Casts;                                 ///< 1 always, 0 never
};

struct RenderOptions;

/// FILE[,radius=R][,intensity=I][,color=R/G/B][,falloff=F][,attenuation=A/B/C][,casts=C]
/// [,casting=N], of which the last is a parameter of the stage. Throws UsageError.
void TakeLamps(RenderOptions& options, const std::string& word);
}

#endif
