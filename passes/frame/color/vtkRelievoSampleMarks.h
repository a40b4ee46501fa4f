// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the pixels that need all of their samples, from a few samples of each: if a pixel's and its
// neighbours' samples are not the values of a plane, there is an edge, a shadow's border or a
// detail of a texture.
//
// Few samples suffice for the mean of linear shades; the second difference of a sample and its two
// neighbours on either side distinguishes these from edges (D. Marr, E. Hildreth, Theory of edge
// detection, 1980).
#ifndef vtkRelievoSampleMarks_h
#define vtkRelievoSampleMarks_h

#include "vtkRelievoInstancedQuads.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTextureBuffer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkRelievoFrameContext;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoSampleMarks : public vtkRelievoResource
{
public:
  ///@{
  // Find() marks pixels in a part of the viewport (x, y, width, height in pixels), for which the
  // resource `samples` has few samples; called for each part between Begin() and Collect(). Each
  // returns an error message, or an empty string.
  std::string Begin(vtkRelievoFrameContext& context, const int part[4]);
  std::string Find(vtkRelievoFrameContext& context, const int part[4]);
  std::string Collect(const int part[4]);
  ///@}

  std::size_t GetNumber() const { return this->Number; }

  // Reduces a part to its marked pixels, which Draw() then draws; false if there are none.
  bool Choose(std::array<int, 4>& part);

  // Whether there may be marked pixels from the least to the most pixel, which are in the viewport;
  // fast.
  bool HasAny(const glm::ivec2& least, const glm::ivec2& most) const
  {
    const glm::ivec2 low = least / Block;
    const glm::ivec2 high = most / Block + 1;
    const int* below = this->Sums.data() + static_cast<std::ptrdiff_t>(low.y) * this->Across;
    const int* above = this->Sums.data() + static_cast<std::ptrdiff_t>(high.y) * this->Across;
    return above[high.x] - above[low.x] != below[high.x] - below[low.x];
  }

  ///@{
  // Draws the chosen marked pixels, or a part and the surroundings that Find() reads, at the
  // farthest depth, into the bound framebuffer. `toRaster` transforms the viewport's NDC.
  std::string Draw(vtkRelievoFrameContext& context, const glm::dmat4& toRaster);
  std::string DrawPart(
    vtkRelievoFrameContext& context, const int part[4], const glm::dmat4& toRaster);
  ///@}

  void Release(vtkWindow* window);

  void Activate(vtkShaderProgram* program) override { this->Target.Activate(program); }
  void Deactivate() override { this->Target.Deactivate(); }

private:
  static constexpr int Block = 4; // pixels

  // Marked pixels of a row.
  struct Run
  {
    int X;
    int Y;
    int Width;
  };

  void Sum(const int size[2]);
  std::string Draw(vtkRelievoFrameContext& context, const std::vector<float>& rectangles,
    const glm::dmat4& toRaster);

  vtkRelievoScreenTarget Target{ "relievoMarks" };
  vtkRelievoScreenQuad Quad;
  vtkRelievoInstancedQuads Pixels;
  vtkRelievoTextureBuffer Rectangles; // x, y, width, height of each
  std::vector<Run> Marked;            // by Y
  std::vector<Run> Chosen;
  std::size_t Number = 0; // of pixels
  // For each corner of blocks of pixels, the number of blocks with marked pixels on its left and
  // below.
  std::vector<int> Sums;
  int Across = 0; // corners
};

#endif
