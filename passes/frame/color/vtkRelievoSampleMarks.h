// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels that need all of their samples, by what a few samples of each show: where these, with
// those of its neighbours, are not the values of a plane, there is an edge, the border of a shadow
// or a detail of a texture.
//
// Means of linear shades are right with a few samples; by the second difference of a sample and of
// two on either side of it these are told from edges (D. Marr, E. Hildreth, Theory of edge
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
  // Finds them in a part of the viewport (x, y, width, height in pixels): part by part of it, of
  // which the resource `samples` has few, between Begin and Collect. Each returns what is wrong, in
  // words.
  std::string Begin(vtkRelievoFrameContext& context, const int part[4]);
  std::string Find(vtkRelievoFrameContext& context, const int part[4]);
  std::string Collect(vtkRelievoFrameContext& context, const int part[4]);
  ///@}

  std::size_t GetNumber() const { return this->Number; }

  // The part of the viewport that has all of them.
  const std::array<int, 4>& GetPart() const { return this->Part; }

  ///@{
  // Draws the marked pixels, or those of a part and all that Find looks at beside it, at the
  // farthest depth, into the framebuffer that is bound. toRaster: from the NDC of the viewport.
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
  vtkRelievoTextureBuffer Runs; // x, y, width, height of rectangles of pixels
  std::size_t NumberOfRuns = 0;
  std::array<int, 4> Part{};
  std::size_t Number = 0;
};

#endif
