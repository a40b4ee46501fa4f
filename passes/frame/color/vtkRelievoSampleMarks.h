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

#include <array>
#include <cstddef>
#include <string>

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
  std::string Collect(vtkRelievoFrameContext& context, const int part[4]);
  ///@}

  std::size_t GetNumber() const { return this->Number; }

  // The part of the viewport that contains all marked pixels.
  const std::array<int, 4>& GetPart() const { return this->Part; }

  ///@{
  // Draws the marked pixels, or a part and the surroundings that Find() reads, at the farthest
  // depth, into the bound framebuffer. `toRaster` transforms the viewport's NDC.
  std::string Draw(vtkRelievoFrameContext& context, const glm::dmat4& toRaster);
  std::string DrawPart(
    vtkRelievoFrameContext& context, const int part[4], const glm::dmat4& toRaster);
  ///@}

  void Release(vtkWindow* window);

  void Activate(vtkShaderProgram* program) override { this->Target.Activate(program); }
  void Deactivate() override { this->Target.Deactivate(); }

private:
  vtkRelievoScreenTarget Target{ "relievoMarks" };
  vtkRelievoScreenQuad Quad;
  vtkRelievoInstancedQuads Pixels;
  vtkRelievoTextureBuffer Runs; // x, y, width, height of each rectangle of pixels
  std::size_t NumberOfRuns = 0;
  std::array<int, 4> Part{};
  std::size_t Number = 0;
};

#endif
