// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Edges in the picture as dashed lines. Connected edges form one line, with dashes along its length
// in pixels: the line begins and ends with half a dash, so that lines meet in corners as in
// drawings by hand, and the dashes between are stretched to fit. The dashes depend on the whole
// line, not on its visible part.
#ifndef vtkRelievoDashes_h
#define vtkRelievoDashes_h

#include "vtkRelievoFormulas.h" // for GLM

#include <cstdint>
#include <vector>

class vtkRelievoDashes
{
public:
  // A segment of a line in the picture, of an edge between two numbered points.
  struct Piece
  {
    std::uint32_t Points[2];
    glm::dvec2 Ends[2]; // in pixels
    double Nearness[2]; // grows towards the eye; linear in the picture of a plane
    bool Smooth;        // continues with another smooth piece at any angle
  };

  static constexpr double Share = 2.0 / 3.0; // share of a line covered by dashes

  // The pieces that meet at a point: their number, and the first two.
  struct Joint
  {
    int First[2];
    int Count = 0;
  };

  // Appends two texels of four floats for each piece near the picture, for
  // shaders/lines/hiddenVS.glsl. Points are numbered from 0 to `points` - 1. `dash` is the length
  // of a dash, roughly, in pixels; shorter lines have no gap.
  void Append(const std::vector<Piece>& pieces, std::uint32_t points, double dash,
    const glm::dvec2& size, std::vector<float>& texels);

private:
  std::vector<Joint> Joints; // by point; valid at points of the latest call's pieces
};

#endif
