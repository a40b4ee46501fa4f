// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FogChord.h
 * @brief The chord as shaders/fog/sphereFS.glsl computes it, in float, on the CPU.
 */
#ifndef relievoTestFogChord_h
#define relievoTestFogChord_h

#include <vtkRelievoFormulas.h>
#include <vtkRelievoSphereRays.h>

namespace relievoTest
{
inline float FloatLack(double value)
{
  return static_cast<float>(value - static_cast<float>(value));
}

/** In radii; pixels from the viewport's lower left corner, `end` is a depth, as a layer has it. */
inline float FogChord(const vtkRelievoSphereRays& rays, const vtkRelievoSphereRays::Sphere& sphere,
  double radius, double x, double y, float end, bool pairs = true)
{
  const glm::dvec4 linear(sphere.Linear, sphere.MiddleDepth);
  const glm::dvec4 square(sphere.Square, 1. / radius);
  glm::vec4 linearLacks(0.f);
  glm::vec4 squareLacks(0.f);
  for (int i = 0; i < 4 && pairs; ++i)
  {
    linearLacks[i] = FloatLack(linear[i]);
    squareLacks[i] = FloatLack(square[i]);
  }
  const glm::vec2 first(rays.GetDirection(glm::dvec2(0.)));
  const glm::mat2 step(rays.GetDirections());
  const glm::vec2 at(static_cast<float>(x), static_cast<float>(y));
  return relievo::f32::relievoFogChordAt(at - glm::vec2(sphere.Pixel), glm::vec4(linear),
    linearLacks, glm::vec4(square), squareLacks, glm::vec2(sphere.Offset),
    glm::vec4(sphere.Offsets[0].x, sphere.Offsets[0].y, sphere.Offsets[1].x, sphere.Offsets[1].y),
    first + step[0] * at.x + step[1] * at.y, end - static_cast<float>(rays.GetBegin()));
}
}

#endif
