// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws once over the frame's viewport with a shader that reads other stages' output: the drawing
// half of a stage that processes the picture.
//
// The shader receives texCoord (vec2, 0 to 1 over the viewport) and the uniforms relievoSize (vec2,
// of the viewport in pixels), relievoNear, relievoFar (float, clipping planes), relievoParallel
// (int), relievoProjection and relievoViewToWorld (mat4). A line `//RELIEVO::Defines` is replaced
// by the defines. Includes for inputs: gbuffer/read.glsl for layers, frame/color.glsl for color.
#ifndef vtkRelievoScreenQuad_h
#define vtkRelievoScreenQuad_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoResourceName.h"

#include <memory>
#include <string>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkRelievoFrameContext;
class vtkRelievoResource;
class vtkShaderProgram;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoScreenQuad
{
public:
  vtkRelievoScreenQuad();
  ~vtkRelievoScreenQuad();
  vtkRelievoScreenQuad(const vtkRelievoScreenQuad&) = delete;
  void operator=(const vtkRelievoScreenQuad&) = delete;

  // The program of this source (a name of vtkRelievoShaderLibrary), ready for its own uniforms;
  // recompiled only after a change of its inputs' structure or of `defines`. nullptr if it does not
  // compile, or if the frame lacks an input: see GetError().
  vtkShaderProgram* Ready(vtkRelievoFrameContext& context, const std::string& source,
    const std::vector<vtkRelievoResourceName>& reads, const std::string& defines = "");
  const std::string& GetError() const { return this->Error; }

  // Use of the bound depth: none; the shader's depth is written; only pixels with a written depth
  // are drawn.
  enum DepthUse
  {
    NO_DEPTH,
    WRITES_DEPTH,
    WHERE_DRAWN
  };

  // Draws with the program returned by Ready() into x, y, width, height (default: the frame's
  // viewport) of the bound framebuffer, with the caller's blending. Limited to the pixels of `part`
  // (x, y, width, height), if given.
  void Draw(vtkRelievoFrameContext& context, const int* viewport = nullptr,
    DepthUse depth = NO_DEPTH, const int* part = nullptr);

  void Release(vtkWindow* window);

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string Key;                            // inputs and defines of the program
  std::vector<vtkRelievoResource*> Resources; // inputs in this frame
  std::string Error;
};

#endif
