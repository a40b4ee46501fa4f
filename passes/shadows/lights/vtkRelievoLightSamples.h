// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points distributed evenly over the shapes of lights with a size, the sizes of lights, and the
// position from which a sample casts a light's shadow.
#ifndef vtkRelievoLightSamples_h
#define vtkRelievoLightSamples_h

#include "vtkLight.h"
#include "vtkRelievoShadowsModule.h" // for the export macro
#include "vtkWeakPointer.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

struct vtkRelievoShadowLight;

namespace vtkRelievoLightSamples
{
// Points of the unit disc: a spiral (H. Vogel, A better way to construct the sunflower head, 1979)
// in an order that is evenly distributed as well; the first is the centre.
VTKRELIEVOSHADOWS_EXPORT glm::dvec2 OnDisc(int sample, int samples);

// Points of the unit ball, with a density of 1 / sqrt(1 - r^2): seen from any side they cover a
// disc evenly, like a glowing ball. The first is the centre.
VTKRELIEVOSHADOWS_EXPORT glm::dvec3 InBall(int sample, int samples);

// Points of the square from -1 to 1; the first is within 1 / samples of the centre.
VTKRELIEVOSHADOWS_EXPORT glm::dvec2 OnSquare(int sample, int samples);
}

// The sizes of a renderer's lights.
class vtkRelievoLightSizes
{
public:
  static constexpr double WidestSun = 90.0;
  static constexpr double LargestLamp = 1e9;

  double SunAngle = 0.53;  // diameter of directional lights, in degrees
  double LampRadius = 0.0; // of positional lights, in world units

  // The size of one light, in the unit of its kind; negative: the common size of its kind.
  void Set(vtkLight* light, double size);
  double Get(vtkLight* light) const;

  // Makes a positional light a parallelogram with these edges, in world coordinates, around its
  // position; edges of zero length remove it.
  void SetEdges(vtkLight* light, const glm::dvec3& first, const glm::dvec3& second);

  // Whether the light is more than a point.
  bool IsSized(vtkLight* light) const;

  // Moves the light to the position from which its shadow is cast.
  void Move(vtkRelievoShadowLight& light, int sample, int samples) const;

private:
  struct Shape
  {
    vtkWeakPointer<vtkLight> Light;
    double Size = -1.0;
    glm::dvec3 Edges[2] = { glm::dvec3(0.0), glm::dvec3(0.0) };

    bool IsFlat() const
    {
      return this->Edges[0] != glm::dvec3(0.0) || this->Edges[1] != glm::dvec3(0.0);
    }
  };

  Shape& GetShape(vtkLight* light);
  const Shape* Find(vtkLight* light) const;

  std::vector<Shape> Shapes;
};

#endif
