// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockShapes.h
 * @brief Shapes with known distance and normal, cut into blocks.
 */
#ifndef relievoBenchBlockShapes_h
#define relievoBenchBlockShapes_h

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkImageData;

namespace relievoBench
{
/** In blocks; block i along an axis is centred at i. */
struct BlockShape
{
  std::string Name;
  int Size = 0;                                          // blocks in each direction
  std::function<double(const glm::dvec3&)> DistanceAt;   // negative inside
  std::function<glm::dvec3(const glm::dvec3&)> NormalAt; // outwards, of length 1
  double Border = 0.; // parts nearer to the border are not measured

  bool IsMeasured(const glm::dvec3& place) const;

  /** Labels 0 and 1 on the points of an image. */
  vtkSmartPointer<vtkImageData> Labels() const;

  /** Positions on the measured part of the shape; always the same. */
  std::vector<glm::dvec3> Samples(int count) const;
};

/** A ball of 0.4 of the size, a tilted torus, and a half space inclined to all axes. */
std::vector<BlockShape> BlockShapes(int size);
}

#endif
