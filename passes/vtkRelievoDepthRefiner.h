// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The depth at the pixels' centres from the mesh in double: the id word says which triangle. A
// rasteriser has two errors that this takes away: it interpolates in float, which on a triangle on
// edge is off by a thousandth; and it rounds corners to parts of a pixel (1/256, as a rule), so that
// a pixel near an edge may be given to the neighbour and extrapolate from there.
#ifndef vtkRelievoDepthRefiner_h
#define vtkRelievoDepthRefiner_h

#include "vtkRelievoDrawTable.h"

struct vtkRelievoView;

class vtkRelievoDepthRefiner
{
public:
  // The id words of the whole view.
  vtkRelievoDepthRefiner(const vtkRelievoDrawTable& draws, const vtkRelievoView& view,
    const std::uint32_t* words, int stride);

  // Replaces the depths of row y where a triangle of a mesh is seen.
  void RefineRow(int y, float* depths);

private:
  // A triangle in eye space; not Known: something else, or a triangle that shader code moves.
  struct Triangle
  {
    bool Known = false;
    glm::dvec3 Corners[3];
  };
  struct Ray
  {
    glm::dvec3 From;
    glm::dvec3 Along;
  };

  std::uint32_t GetWord(int x, int y) const;
  Triangle GetTriangle(std::uint32_t word) const;
  Ray GetRay(int x, int y) const;

  // Depth where the ray meets the triangle, or the point of it that is nearest to that.
  static double GetDepth(const Triangle& triangle, const Ray& ray, bool& inside);

  // Depth on the neighbours' triangle that holds the pixel's centre, else what is given.
  double GetNeighbourDepth(int x, int y, const Ray& ray, double depth) const;

  const vtkRelievoDrawTable& Draws;
  const vtkRelievoView& View;
  const std::uint32_t* Words;
  int Stride;
};

#endif
