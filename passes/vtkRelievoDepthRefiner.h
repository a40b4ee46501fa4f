// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The depth at the pixels' centres from the mesh in double: the id word says which triangle. A
// rasteriser has two errors that this takes away: it interpolates in float, which on a triangle on
// edge is off by a thousandth; and it rounds corners to parts of a pixel (1/256, as a rule), so that
// a pixel near an edge may be given to the neighbour and extrapolate from there. The triangle that
// truly holds the centre is looked for among those of the neighbouring pixels, then, for slivers that
// no pixel shows, among those that share a point with the triangle shown.
#ifndef vtkRelievoDepthRefiner_h
#define vtkRelievoDepthRefiner_h

#include "vtkRelievoDrawTable.h"

#include <vector>

class vtkRelievoMeshLinks;
struct vtkRelievoView;

class vtkRelievoDepthRefiner
{
public:
  // The id words of the whole view.
  vtkRelievoDepthRefiner(const vtkRelievoDrawTable& draws, const vtkRelievoView& view,
    const std::uint32_t* words, int stride);

  // Replaces the view's depths where a triangle of a mesh is seen.
  void Refine(float* depths, vtkRelievoMeshLinks& links);

private:
  struct Pixel
  {
    int X;
    int Y;
  };
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

  // Those of row y; pixels whose centre no triangle at hand holds are added to `open`.
  void RefineRow(int y, float* depths, std::vector<Pixel>& open) const;

  // Depth on the neighbours' triangle that holds the pixel's centre; infinity if none does.
  double GetNeighbourDepth(int x, int y, const Ray& ray, double depth) const;
  double GetAdjacentDepth(int x, int y, double depth, vtkRelievoMeshLinks& links) const;

  const vtkRelievoDrawTable& Draws;
  const vtkRelievoView& View;
  const std::uint32_t* Words;
  int Stride;
};

#endif
