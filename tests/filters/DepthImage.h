// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthImage.h
 * @brief Depth images of a plane and a sphere as a camera sees them, from geometry in double.
 */
#ifndef relievoTestDepthImage_h
#define relievoTestDepthImage_h

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace relievoTest
{
/** A view on a small scene about `Center`: a plane through it and a sphere of radius 1 above. */
struct DepthView
{
  const char* Name;
  glm::dvec3 Center;
  bool Parallel;
  glm::dvec2 WindowCenter;
  glm::ivec2 Size;
};

/** The camera of a view, 8 units from its centre. */
vtkSmartPointer<vtkCamera> MakeCamera(const DepthView& view);

struct DepthImage
{
  vtkSmartPointer<vtkImageData> Image;
  std::vector<glm::dvec3> Positions; // of the pixels that see something, relative to the centre
  std::vector<vtkIdType> Pixels;     // their numbers in the image
};

/**
 * Intersects each pixel's ray with plane and sphere, in coordinates relative to the view's centre.
 * The image has a double (or float) array "depth", +infinity in the background; an int array "id"
 * (0 plane, 1 sphere, -1 nothing); a float array "normal" of 3; and the camera in its field data.
 */
DepthImage MakeDepthImage(const DepthView& view, bool asFloat = false);
}

#endif
