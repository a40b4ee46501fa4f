// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A light of a renderer as its shadows see it: where it is, what it reaches, whether it casts.
#ifndef vtkRelievoShadowLight_h
#define vtkRelievoShadowLight_h

#include "vtkRelievoFormulas.h" // for GLM

#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

struct vtkRelievoShadowLight
{
  vtkLight* Light = nullptr;
  int Number = 0;       // place in vtkRenderer::GetLights()
  int ShaderIndex = -1; // among the lights that are on, as VTK's shaders count; -1 if off
  bool Positional = false;
  double ConeAngle = 90.0;            // degrees from the axis; 90 and more: all directions
  glm::dvec3 Position{ 0.0 };         // world, of positional lights
  glm::dvec3 Direction{ 0.0, 0, -1 }; // world, unit, the way the light goes
  double Reach = 0.0;                 // of positional lights: nothing beyond is lit; 0: no end
  // Of a sun whose parts are looked up in a few maps: the way that a part's light goes, and the
  // map; the way of a map's light, and the tangent of the widest angle to the parts that it is for.
  // Empty, and 0, of a point.
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
  double Spread = 0.0;  // the tangent of the widest angle of all parts to the light's direction
  std::string NoShadow; // why it casts none, in words; empty if it casts
  bool Broken = false;  // it could not cast if it were asked to: worth a warning

  // A unit vector square to a direction.
  static glm::dvec3 AnySquareTo(const glm::dvec3& direction);

  bool IsSpot() const { return this->Positional && this->ConeAngle < 90.0; }

  // All lights of the renderer. Headlights are marked as casting none: no shadow of a light at the
  // eye is seen.
  static std::vector<vtkRelievoShadowLight> Collect(vtkRenderer* renderer);
};

#endif
