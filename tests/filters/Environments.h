// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Environments.h
 * @brief Environment images from formulas, in every projection, and how far an image is from one.
 */
#ifndef relievoTestEnvironments_h
#define relievoTestEnvironments_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <functional>

namespace relievoTest
{
/** Light from a unit direction. */
using Light = std::function<glm::dvec3(const glm::dvec3& direction)>;

/** Projections as vtkRelievoEnvironmentConvert numbers them: 1 equirectangular, 2 cube, 3 ball. */
constexpr int Equirectangular = 1;
constexpr int Cube = 2;
constexpr int SphereMap = 3;

/**
 * Unit direction of the place (column, row) of an image, counted in texels from the first one's
 * outer corner; written out here, so that the filters' formulas are not judged by themselves. A
 * zero vector outside of a sphere map's circle.
 */
glm::dvec3 DirectionOf(int projection, const int size[3], int slice, double column, double row);

/** Solid angle of a texel, from its middle; 0 where the middle is outside of the circle. */
double SolidAngleOf(int projection, const int size[3], int slice, int column, int row);

/** Size of an environment: 2n x n x 1, n x n x 6, n x n x 1. */
void SizeOf(int projection, int n, int size[3]);

/** The light in the middle of each texel, as float scalars "radiance". */
vtkSmartPointer<vtkImageData> MakeEnvironment(const Light& light, int projection, int n);

/** Sum over all texels of light times solid angle. */
glm::dvec3 FluxOf(vtkImageData* image, int projection);

/** For a sphere map, compares only texels up to this direction: 20 degrees before -z. */
constexpr double BallEnd = -0.94;

/** |image - mean of light over the texel| over the light's mean: all texels, those at borders. */
struct LightErrors
{
  double Mean;
  double Worst;
  double WorstBorder;
};
LightErrors ErrorsOf(vtkImageData* image, int projection, const Light& light);

/** A smooth environment, 0.2 to 3, different in every direction and channel. */
glm::dvec3 SmoothLight(const glm::dvec3& direction);
}

#endif
