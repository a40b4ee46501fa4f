// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Edges in the picture as dashed lines. Edges that follow each other are one line, with dashes by
// its length in pixels: it begins and ends with half a dash, as lines that meet in a corner are
// drawn by hand, and the dashes between are stretched to fit. What it looks like depends on the
// whole line, and not on what of it is seen.
#ifndef vtkRelievoDashes_h
#define vtkRelievoDashes_h

#include "vtkRelievoFormulas.h" // for GLM

#include <cstdint>
#include <vector>

class vtkRelievoDashes
{
public:
  // A piece of a line in the picture, of an edge between two numbered points.
  struct Piece
  {
    std::uint32_t Points[2];
    glm::dvec2 Ends[2]; // in pixels
    double Nearness[2]; // grows towards the eye; straight in the picture of a plane
    bool Smooth;        // it goes on where another smooth one does, whatever the angle
  };

  static constexpr double Share = 2.0 / 3.0; // that dashes are of a line

  // The pieces that meet at a point: how many, and the first two of them.
  struct Meeting
  {
    int First[2];
    int Count = 0;
  };

  // Appends what shaders/lines/hiddenVS.glsl reads of each piece that is near the picture: two
  // texels of four floats. Points are numbered from 0 to `points` - 1. A dash is about so many
  // pixels long; lines shorter than one are whole.
  void Append(const std::vector<Piece>& pieces, std::uint32_t points, double dash,
    const glm::dvec2& size, std::vector<float>& texels);

private:
  std::vector<Meeting> Meetings; // by point; good where a piece of the latest call has one
};

#endif
