// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fill lights: distant lights without shadows that stand for the light of all surroundings. The
// stage `fill` draws them as one smooth light; without it they are lights like others.
#ifndef vtkRelievoFillLight_h
#define vtkRelievoFillLight_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkLight;

struct VTKRELIEVOFRAME_EXPORT vtkRelievoFillLight
{
  // Marks a distant light as a fill light; Clear makes it a light like others.
  static void Make(vtkLight* light);
  static void Clear(vtkLight* light);
  static bool Is(vtkLight* light);

  // The nine coefficients of distant lights, for shaders/formulas/light/irradiance.glsl, which
  // approximates the light of VTK's own shaders. `towards`: unit vectors to the lights.
  static std::array<glm::vec3, 9> GetCoefficients(
    const std::vector<glm::dvec3>& towards, const std::vector<glm::dvec3>& colors);
};

#endif
