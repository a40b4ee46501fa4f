// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of an environment as OpenGL is to have them: floats, red, green, blue.
#ifndef vtkRelievoEnvironmentImages_h
#define vtkRelievoEnvironmentImages_h

#include <string>
#include <vector>

class vtkImageData;

namespace vtkRelievoEnvironmentImages
{
// The numbers are those of vtkRelievoEnvironment::ProjectionType.
enum Projection
{
  Automatic = 0,
  Equirectangular = 1,
  Cube = 2,
  SphereMap = 3
};

// The projection of the image, `projection` or by its size; 0, with words in `failure`, if it has
// another shape.
int FindProjection(vtkImageData* image, int projection, std::string& failure);

struct Pixels
{
  int Width = 0;
  int Height = 0;
  int Slices = 0;
  float Greatest = 0.f;
  std::vector<float> Values;
};

// The image's values, at most `limit` texels wide and high: larger ones as means. What lies outside
// of a sphere map's circle holds what is nearest within.
Pixels Read(vtkImageData* image, int projection, bool sRGB, int limit);
}

#endif
