// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReliefTruth.h
 * @brief Height fields in closed form below a plane, their images, and hits of rays.
 *
 * The plane is z = 0 with texture coordinates u = (x + 1) / 2, v = (y + 1) / 2; heights run from 0
 * on the ground, `scale` below the plane, to 1 on it.
 */
#ifndef relievoTestReliefTruth_h
#define relievoTestReliefTruth_h

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <functional>

namespace relievoTest
{
/** A height of [0, 1] for texture coordinates, with period 1 in each. */
using HeightField = std::function<double(const glm::dvec2&)>;

/** Three waves. */
double Waves(const glm::dvec2& uv);

/** Square posts, 8 x 8 in a tile, with sides of this share of a tile, on level ground. */
HeightField Posts(double side);

/** A texture of the field with size x size texels, interpolated linearly between their centres. */
HeightField Sampled(const HeightField& field, int size);

/** Slope of the field with u and v, by differences in double precision. */
glm::dvec2 SlopeOf(const HeightField& field, const glm::dvec2& uv);

/** The field at texel centres, one float component; row 0 is at v = 0. */
vtkSmartPointer<vtkImageData> HeightImage(const HeightField& field, int size);

/** Tangent-space normals of the field `scale` high (the plane's tile is 2 long), three floats. */
vtkSmartPointer<vtkImageData> NormalImage(const HeightField& field, int size, double scale = 0.2);

/** The plane from (-1, -1, 0) to (1, 1, 0) with texture coordinates, of cells x cells quads. */
vtkSmartPointer<vtkPolyData> ReliefPlane(int cells);

/** A ray of a pixel's centre through the plane. */
struct ReliefRay
{
  glm::dvec3 Origin{ 0. };
  glm::dvec3 Direction{ 0. }; // unit
  double AxisPerLength = 1.;  // eye-space depth gained per length of the ray
  glm::dvec3 OnPlane{ 0. };
  bool HitsPlane = false; // inside the plane's square, from above
};
ReliefRay RayOf(vtkRenderer* renderer, int x, int y);

/**
 * The ray's hit with the field, below the plane: depth from 0 (plane) to 1 (ground), to 1e-9. The
 * field is first sampled `looks` times along the ray.
 */
double MeetRelief(const HeightField& field, const ReliefRay& ray, double scale, int looks = 5000);

/** Errors of a picture against the truth. */
struct ReliefErrors
{
  int Rays = 0;
  double Missed = 0.; // share of rays with an error above 5 % of the relief's height
  double Depth = 0.;  // mean of the others, as a share of the relief's height
  double Normal = 0.; // mean of the others, degrees; 0 without the layer
};

/**
 * Compares the layers `depth` and `normal` (may be missing) of a picture of the plane with rays
 * through the field, every `stride`-th pixel of every `stride`-th row.
 */
ReliefErrors CompareRelief(vtkImageData* layers, vtkRenderer* renderer, const HeightField& field,
  double scale, int stride = 5);

/** Puts the camera 4 from the plane's middle, so many degrees off its normal. */
void LookAtRelief(vtkRenderer* renderer, double degrees, bool parallel = false);

/** The texture coordinates at a depth along the ray. */
glm::dvec2 ReliefTCoord(const ReliefRay& ray, double scale, double depth);
}

#endif
