// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of an environment, converted for OpenGL: floats, red, green, blue.
#ifndef vtkRelievoEnvironmentImages_h
#define vtkRelievoEnvironmentImages_h

#include "codes.glsl"

#include <string>
#include <vector>

class vtkImageData;

namespace vtkRelievoEnvironmentImages
{
// Equal to vtkRelievoEnvironment::ProjectionType.
enum Projection
{
  Automatic = 0,
  Equirectangular = RELIEVO_ENVIRONMENT_EQUIRECTANGULAR,
  Cube = RELIEVO_ENVIRONMENT_CUBE,
  SphereMap = RELIEVO_ENVIRONMENT_SPHERE_MAP
};

// The projection of the image: `projection`, or by its size; 0 and a message in `failure` if the
// shape does not fit.
int FindProjection(vtkImageData* image, int projection, std::string& failure);

struct Pixels
{
  int Width = 0;
  int Height = 0;
  int Slices = 0;
  float Greatest = 0.f;
  std::vector<float> Values;
};

// The image's values, at most `limit` texels wide and high: larger images are reduced by means.
// Texels outside a sphere map's circle get the nearest value inside.
Pixels Read(vtkImageData* image, int projection, bool sRGB, int limit);
}

#endif
