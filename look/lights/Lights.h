// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights of a renderer.
 */
#ifndef Lights_h
#define Lights_h

#include "LookNames.h"

#include <vector>

class vtkRenderer;

namespace look
{
struct LightChoice;

/// Replaces the renderer's lights by these, if there are any; `up`: the axis that points up. If
/// neither has any, light comes only from the `environment`.
void AddLights(
  vtkRenderer* renderer, const std::vector<LightChoice>& lights, int up, bool environment);

/// Throws UsageError or WorkError for more lights than can be drawn, those chosen or the files'.
void CheckLights(vtkRenderer* renderer, const std::vector<LightChoice>& lights);

/// The row of --light.
void AddLightOption(OptionRows& rows, std::vector<LightChoice>& lights);
}

#endif
