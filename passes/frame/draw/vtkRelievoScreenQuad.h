// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws once over the frame's viewport with a shader that reads what other stages wrote: the
// drawing half of a stage that works on the picture.
//
// The shader is given texCoord (vec2, 0 to 1 over the viewport) and the uniforms relievoSize (vec2,
// of the viewport in pixels), relievoNear, relievoFar (float, clipping planes), relievoParallel
// (int), relievoProjection and relievoViewToWorld (mat4). A line `//RELIEVO::Defines` takes the
// defines. What it includes for what it reads: layers: gbuffer/read.glsl; color: frame/color.glsl.
#ifndef vtkRelievoScreenQuad_h
#define vtkRelievoScreenQuad_h

#include "vtkRelievoFrameModule.h" // for the export macro

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

  // The program of this source (a name of vtkRelievoShaderLibrary), ready for uniforms of its own;
  // compiled again only when the structure of what it reads, or `defines`, has changed. nullptr if
  // it does not compile, or if the frame lacks what it reads; GetWrong says which.
  vtkShaderProgram* Ready(vtkRelievoFrameContext& context, const std::string& source,
    const std::vector<std::string>& reads, const std::string& defines = "");
  const std::string& GetWrong() const { return this->Wrong; }

  // What a quad does with the depth that is bound: nothing; the shader's depth is written; only
  // pixels whose depth something has written are drawn.
  enum DepthUse
  {
    NO_DEPTH,
    WRITES_DEPTH,
    WHERE_DRAWN
  };

  // Draws with the program that Ready returned into x, y, width, height (default: the frame's
  // viewport) of the bound framebuffer. Blending is as the caller set it. Only the pixels of `part`
  // (x, y, width, height) are drawn, if it is given.
  void Draw(vtkRelievoFrameContext& context, const int* viewport = nullptr,
    DepthUse depth = NO_DEPTH, const int* part = nullptr);

  void Release(vtkWindow* window);

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string Key;                            // what the program was compiled for
  std::vector<vtkRelievoResource*> Resources; // of this frame
  std::string Wrong;
};

#endif
