// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps from data that cast shadows: what lights them says in the frame's context, before anything
// is drawn, which lamps these are; the resource `lamp shadows` then has their maps. Shaders include
// shadow/lamp.glsl.
#ifndef vtkRelievoLampShadows_h
#define vtkRelievoLampShadows_h

#include "vtkRelievoResource.h"

#include <glm/vec3.hpp>

struct vtkRelievoCastingLamp
{
  static constexpr int Most = 8; // in a frame

  glm::dvec3 Position; // world
  double Radius;       // nothing beyond is lit
  double Strength;     // share of a blocked light that is removed, 0 to 1
};

class VTKRELIEVOFRAME_EXPORT vtkRelievoLampShadows : public vtkRelievoResource
{
public:
  // The uniforms of one of the context's casting lamps, after Activate.
  virtual void SetLamp(vtkShaderProgram* program, int lamp) = 0;
};

#endif
