// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file View.h
 * @brief The rays of a renderer's pixels, in double precision, from the camera's own numbers.
 *
 * Built from position, focal point, view-up, angle, scale and window centre, without VTK's
 * transforms, so that it is independent of the drawing that it checks.
 */
#ifndef relievoTestView_h
#define relievoTestView_h

#include <glm/glm.hpp>

class vtkRenderer;

namespace relievoTest
{
/**
 * A ray: Origin + t * Direction. For a View, Direction's part along the view is 1: t is the depth.
 */
struct Ray
{
  glm::dvec3 Origin{ 0. };
  glm::dvec3 Direction{ 0. };

  glm::dvec3 At(double t) const { return this->Origin + t * this->Direction; }
};

/**
 * A renderer's view. Pixel coordinates are those of its viewport: (0, 0) is the outer corner at the
 * lower left, the centre of pixel (i, j) is (i + 0.5, j + 0.5).
 */
class View
{
public:
  /**
   * Reads the renderer's active camera, viewport and window size. The renderer must be in a window.
   * Fails the test for unsupported features: stereo, tiles, view shear, off-axis and explicit
   * projections, user and model transforms.
   */
  explicit View(vtkRenderer* renderer);

  /** The ray through a place of the viewport, in pixels. */
  Ray PixelRay(double x, double y) const;

  /** Eye space -z of a point, world units; negative behind the eye. */
  double Depth(const glm::dvec3& world) const;

  /**
   * The drawn position of a point, in pixels. False, with `pixel` unchanged, for a point at or
   * behind the eye of a perspective view.
   */
  bool Project(const glm::dvec3& world, glm::dvec2& pixel) const;

  /** Size of the viewport and its lower left pixel in the window. */
  int Width = 0;
  int Height = 0;
  int Left = 0;
  int Bottom = 0;

  /** The camera's position, and its unit axes in world space. */
  glm::dvec3 Eye{ 0. };
  glm::dvec3 Right{ 0. };
  glm::dvec3 Up{ 0. };
  glm::dvec3 Forward{ 0. };

  /** The range of depth that is drawn. */
  double Near = 0.;
  double Far = 0.;

  bool Parallel = false;

private:
  // Half the size of the view: at depth 1 in perspective, at any depth in parallel projection.
  glm::dvec2 Half{ 1. };
  // The camera's window centre, in halves of the viewport.
  glm::dvec2 Center{ 0. };
};
}

#endif
