// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The exact NDC rectangle of a sphere, or of its part between two depths, seen by a camera: in
// perspective, parallel, off-centre and sheared projections, also for a sphere around the camera.
//
// Planes of constant NDC x that touch the sphere are the roots of a quadratic equation; the
// extremes are those touching points that lie between the two depths, or on the circles at which
// the sphere is cut (M. Mara and M. McGuire, 2D Polyhedral Bounds of a Clipped,
// Perspective-Projected 3D Sphere, JCGT 2(2), 2013, for centred perspective).
#ifndef vtkRelievoSphereBounds_h
#define vtkRelievoSphereBounds_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

class VTKRELIEVOFRAME_EXPORT vtkRelievoSphereBounds
{
public:
  // `viewToNDC`: see vtkRelievoFrameCamera::ViewToNDC.
  explicit vtkRelievoSphereBounds(const glm::dmat4& viewToNDC);

  struct Sphere
  {
    glm::dvec3 Center; // eye space
    double Radius;
  };

  // The least and the greatest NDC x (axis 0) or y (axis 1) of the sphere's part between two
  // depths, 0 < from <= to (any sign in parallel projection); false if this part is empty.
  bool FindExtent(
    const Sphere& sphere, int axis, double from, double to, double& least, double& most) const;

  // Both axes, as x0, y0, x1, y1, clipped to the view, -1 to 1; false if the sphere is out of view.
  bool FindRectangle(const Sphere& sphere, double from, double to, double rectangle[4]) const;

  // The plane at which NDC x (or y) is `ndc`: unit normal towards greater values, and offset.
  glm::dvec4 GetPlane(int axis, double ndc) const;

private:
  glm::dvec4 Rows[3]; // of x, y and w
  bool Usual;         // w depends on the depth alone

  // For the normals of x and y: their lengths across the view, and their products with themselves
  // and with the normal of w; and that normal's product with itself.
  double Across[2];
  double Square[2];
  double Mixed[2];
  double SquareW;
};

#endif
