// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All markers of each pixel, one over the other: each draws its rectangle.
#ifndef vtkRelievoMarkerBuffer_h
#define vtkRelievoMarkerBuffer_h

#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTextureBuffer.h"

#include <string>

class vtkRelievoFrameContext;
class vtkRelievoMarkerList;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoMarkerBuffer
{
public:
  vtkRelievoMarkerBuffer();
  ~vtkRelievoMarkerBuffer();

  // Draws them. Returns what is wrong, in words.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoMarkerList& list);

  // Colour times what is covered, and what is covered; `markersOver` in shaders.
  vtkRelievoScreenTarget Target;

  vtkIdType GetBytes() const { return this->Target.GetBytes() + this->Markers.GetBytes(); }
  void Release(vtkWindow* window);

private:
  std::string Compile(vtkRelievoFrameContext& context, const std::string& defines);
  void DrawAll(vtkRelievoFrameContext& context, int count);

  vtkRelievoTextureBuffer Markers;
  std::string Key;                     // what the program was compiled for
  vtkShaderProgram* Program = nullptr; // null: it did not compile
  unsigned int Arrays = 0;             // none, but OpenGL draws nothing without their object
};

#endif
