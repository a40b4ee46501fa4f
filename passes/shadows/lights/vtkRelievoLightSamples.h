// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points spread evenly over the shapes of lights with a size: how large they are, and where a
// light's shadow is cast from in one of so many samples.
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
// Of the unit disc: a spiral (H. Vogel, A better way to construct the sunflower head, 1979) whose
// points come in an order that is spread out as well; the first is the centre.
VTKRELIEVOSHADOWS_EXPORT glm::dvec2 OnDisc(int sample, int samples);

// Of the unit ball, denser towards its surface as 1 / sqrt(1 - r^2): from every side it is seen as
// an evenly covered disc, as a glowing ball is. The first is the centre.
VTKRELIEVOSHADOWS_EXPORT glm::dvec3 InBall(int sample, int samples);

// Of the square from -1 to 1; the first is within 1 / samples of its middle.
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

  // Of one light, in the unit of its kind; negative: as the others of its kind.
  void Set(vtkLight* light, double size);
  double Get(vtkLight* light) const;

  // A positional light that is a parallelogram with these edges, in world coordinates, around its
  // position; edges of no length: it is none.
  void SetEdges(vtkLight* light, const glm::dvec3& first, const glm::dvec3& second);

  // Whether the light is more than a point.
  bool IsSized(vtkLight* light) const;

  // To where its shadow is cast from.
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
