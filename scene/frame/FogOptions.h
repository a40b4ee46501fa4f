// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of --fog.
 */
#ifndef FogOptions_h
#define FogOptions_h

#include "PointValue.h"

#include <string>
#include <vector>

namespace scene
{
struct FogChoice
{
  std::string File;
  PointValue Radius;
  PointValue Density;
  ColorValue Color;
  std::string Mode; ///< beer or chord; empty: not said
};

/// FILE[,radius=R][,density=D][,color=R/G/B][,mode=beer|chord]. Throws UsageError.
FogChoice ParseFog(const std::string& word);

/// Throws UsageError if they do not go together.
void CheckFogs(const std::vector<FogChoice>& fogs);
}

#endif
