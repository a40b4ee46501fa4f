// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Quads, each an instance, whose corners a vertex shader places: it knows them by gl_InstanceID,
// and the corners of each by gl_VertexID, 0 to 3 along a strip.
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

  // The program of these files of the shader library, with the defines in both, compiled when they
  // change, and current; the frame's size, clipping planes and projection are set, as
  // vtkRelievoScreenQuad names them. nullptr if it does not compile: GetWrong says so.
  vtkShaderProgram* Ready(vtkRelievoFrameContext& context, const std::string& vertices,
    const std::string& fragments, const std::string& defines);
  const std::string& GetWrong() const { return this->Wrong; }

  // Draws so many with the program that is current, into what is bound.
  void Draw(int count);

  void Release(vtkWindow* window);

private:
  std::string Key; // what the program was compiled of
  std::string Wrong;
  vtkShaderProgram* Program = nullptr;
  unsigned int Arrays = 0; // none, but OpenGL draws nothing without their object
};

#endif
