// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps from data that cast shadows: the lighting stage lists them in the frame's context before
// any drawing; the resource `lamp shadows` then has their maps. Shaders include shadow/lamp.glsl.
#ifndef vtkRelievoLampShadows_h
#define vtkRelievoLampShadows_h

#include "vtkRelievoResource.h"

#include <glm/vec3.hpp>

struct vtkRelievoCastingLamp
{
  static constexpr int Most = 8; // per frame

  glm::dvec3 Position; // world
  double Radius;       // reach of the light
  double Strength;     // share of blocked light that is removed, 0 to 1
};

class VTKRELIEVOFRAME_EXPORT vtkRelievoLampShadows : public vtkRelievoResource
{
public:
  // Sets the uniforms of one of the context's casting lamps, after Activate().
  virtual void SetLamp(vtkShaderProgram* program, int lamp) = 0;
};

#endif
