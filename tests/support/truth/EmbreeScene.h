// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EmbreeScene.h
 * @brief Truth for triangles: Embree finds the triangle, double precision computes the hit.
 */
#ifndef relievoTestEmbreeScene_h
#define relievoTestEmbreeScene_h

#include "Truth.h"

#include <array>
#include <memory>

class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;

namespace relievoTest
{
/** Whether a light is visible from a position, and how certain that is. */
struct ShadowVerdict
{
  bool Occluded = false;
  /** False if the verdict flips for one of the jittered rays: exclude such positions. */
  bool Stable = true;
};

/**
 * The polygons and strips of vtkPolyData, cut into triangles as VTK's OpenGL mapper cuts them
 * (polygons as fans from their first point), placed by their actors' matrices in double precision.
 * Left out: vertices and lines, triangles with two equal points or a point that is not finite.
 *
 * Embree works in float, about the scene's own centre and from where the ray enters the scene, with
 * the robust flag; it only chooses the triangle. Position and depth come from the ray and the
 * triangle's plane in double.
 *
 * Add everything first; casting is thread-safe.
 */
class EmbreeScene
{
public:
  EmbreeScene();
  ~EmbreeScene();

  /** Adds a mesh, copied; null `matrix` is the identity. Returns the index of the actor. */
  int AddActor(vtkPolyData* mesh, vtkMatrix4x4* matrix = nullptr);

  /**
   * Adds every visible vtkActor of a renderer whose mapper is a vtkPolyDataMapper, in the
   * renderer's order; others are left out. Returns the number of added actors.
   */
  int AddActors(vtkRenderer* renderer);

  long long NumberOfTriangles() const;

  /** Corners of a triangle in world space, in VTK's order. */
  std::array<glm::dvec3, 3> Corners(long long triangle) const;

  /** Ids of a triangle's points in its actor's vtkPolyData. */
  std::array<long long, 3> PointIds(long long triangle) const;

  /** Weights of the corners at a position on the triangle's plane; they sum to 1. */
  glm::dvec3 Weights(long long triangle, const glm::dvec3& position) const;

  /** First hit of a ray with t in [tMin, tMax]. `ignored`: a triangle to ignore. */
  SurfacePoint Cast(const Ray& ray, double tMin, double tMax, long long ignored = -1) const;

  /** The truth for every pixel. */
  TruthImage Trace(const View& view) const;

  /**
   * Whether the path from a surface point along `toLight` is blocked within tMax times that vector
   * (infinity for a sun). The point's own triangle does not block; others do from a millionth of
   * the scene's size on. The verdict is stable if four more rays, starting `jitter` (world units)
   * away in the surface's plane, agree.
   */
  ShadowVerdict Shadow(
    const SurfacePoint& point, const glm::dvec3& toLight, double tMax, double jitter) const;

  /** Length of the diagonal of the box around all triangles. */
  double Size() const;

  EmbreeScene(const EmbreeScene&) = delete;
  void operator=(const EmbreeScene&) = delete;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
