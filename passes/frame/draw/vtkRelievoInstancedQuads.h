// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Instanced quads whose corners are computed by a vertex shader from gl_InstanceID, and
// gl_VertexID, 0 to 3 along a strip.
#ifndef vtkRelievoInstancedQuads_h
#define vtkRelievoInstancedQuads_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <string>

class vtkRelievoFrameContext;
class vtkShaderProgram;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoInstancedQuads
{
public:
  vtkRelievoInstancedQuads() = default;
  ~vtkRelievoInstancedQuads() = default;
  vtkRelievoInstancedQuads(const vtkRelievoInstancedQuads&) = delete;
  void operator=(const vtkRelievoInstancedQuads&) = delete;

  // The program of these files of the shader library, with the defines in both, current, and
  // recompiled after a change; the frame's size, clipping planes and projection are set by the
  // uniforms of vtkRelievoScreenQuad. nullptr if it does not compile: see GetError().
  vtkShaderProgram* Ready(vtkRelievoFrameContext& context, const std::string& vertices,
    const std::string& fragments, const std::string& defines);
  const std::string& GetError() const { return this->Error; }

  // Draws `count` quads with the current program into the bound framebuffer.
  void Draw(int count);

  void Release(vtkWindow* window);

private:
  std::string Key; // source of the program
  std::string Error;
  vtkShaderProgram* Program = nullptr;
  unsigned int Arrays = 0; // empty, but OpenGL requires the object
};

#endif
