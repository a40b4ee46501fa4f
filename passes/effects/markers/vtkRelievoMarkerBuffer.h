// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All markers of each pixel, one over the other: each draws its rectangle.
#ifndef vtkRelievoMarkerBuffer_h
#define vtkRelievoMarkerBuffer_h

#include "vtkRelievoInstancedQuads.h"
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
  void DrawAll(vtkRelievoFrameContext& context, vtkShaderProgram* program, int count);

  vtkRelievoTextureBuffer Markers;
  vtkRelievoInstancedQuads Quads;
};

#endif
