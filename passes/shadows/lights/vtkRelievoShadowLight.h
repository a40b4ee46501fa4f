// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A light of a renderer with the properties for shadows: position, reach, whether it casts.
#ifndef vtkRelievoShadowLight_h
#define vtkRelievoShadowLight_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkRelievoOpticalDepths.h"

#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

struct vtkRelievoShadowLight
{
  vtkLight* Light = nullptr;
  int Number = 0;       // index in vtkRenderer::GetLights()
  int ShaderIndex = -1; // index among lights that are on, as in VTK's shaders; -1 if off
  bool Positional = false;
  double ConeAngle = 90.0;            // degrees from the axis; 90 and more: all directions
  glm::dvec3 Position{ 0.0 };         // world, for positional lights
  glm::dvec3 Direction{ 0.0, 0, -1 }; // world, unit, direction of the light's rays
  double Reach = 0.0; // for positional lights: radius of the lit region; 0: unlimited
  // For a sun whose parts share a few maps: the direction of a part's rays, and the map; the
  // direction of a map's rays, and the tangent of the widest angle to its parts. Empty, and 0, for
  // a point light.
  struct Part
  {
    glm::dvec3 Direction{ 0.0 };
    int Map = 0;
  };
  struct Center
  {
    glm::dvec3 Direction{ 0.0 };
    double Spread = 0.0;
  };
  std::vector<Part> Parts;
  std::vector<Center> Centers;
  double Spread = 0.0;  // tangent of the widest angle of all parts to the light's direction
  std::string NoShadow; // reason why it casts none; empty if it casts
  bool Broken = false;  // it could never cast: worth a warning
  bool AtEye = false;   // all that the eye sees is lit by it: it needs no maps

  // A unit vector square to a direction.
  static glm::dvec3 AnySquareTo(const glm::dvec3& direction);

  // The share of its light that its shadows take, of the strength of all shadows.
  double GetStrength() const;

  bool IsSpot() const { return this->Positional && this->ConeAngle < 90.0; }

  // For the depths of volumes.
  vtkRelievoOpticalDepths::Source GetSource() const
  {
    return { this->Positional, this->Position, this->Direction };
  }

  // All lights of the renderer. Headlights are marked as casting none: the shadow of a light at the
  // eye is invisible.
  static std::vector<vtkRelievoShadowLight> Collect(vtkRenderer* renderer);
};

#endif
