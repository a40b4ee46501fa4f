// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the depths of triangles and points into a square map in memory, as OpenGL draws them: a
// texel is covered if its centre is, and the centres on an edge between two triangles belong to one
// of them. For software OpenGL, which needs several times as long for triangles smaller than a
// texel, and for points. The depths do not depend on the number of threads.
#ifndef vtkRelievoDepthRaster_h
#define vtkRelievoDepthRaster_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkRelievoPointGroups.h"

#include <cstddef>
#include <vector>

class vtkRelievoDepthRaster
{
public:
  // Triangles as in OpenGL's buffers.
  struct Mesh
  {
    const float* Places = nullptr; // of corners, three numbers each
    std::size_t NumberOfPlaces = 0;
    std::size_t Step = 3; // numbers from one place to the next
    const unsigned int* Corners = nullptr;
    std::size_t Triangles = 0;
  };

  // Sets all depths of a map of size x size texels to 1, the farthest one. Throws std::bad_alloc.
  void Clear(int size);

  // Draws into a part of the map (x, y, width, height in texels) that covers NDC from -1 to 1.
  // `clamps`: places in front of the near plane get depth 0; otherwise they are cut off.
  // Triangles with a corner that is no place are left out. Throws std::bad_alloc, in this thread.
  void Draw(const Mesh& mesh, const glm::dmat4& modelToNDC, const int region[4], bool clamps);

  // Draws points in the same way, as discs with the depth of the point and a diameter in texels:
  // the spheres of VTK's, without their bulge, which would have them shadow themselves.
  void Draw(const vtkRelievoPointGroups::Mesh& points, double diameter,
    const glm::dmat4& modelToNDC, const int region[4], bool clamps);

  // Row by row, from the lowest one; empty if nothing was drawn since Clear.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  void Allocate();

  std::vector<float> Depths;
  int Size = 0;
};

#endif
