// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Composites all markers of each pixel in order: each marker draws its rectangle.
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

  // Draws the markers. Returns an error message, or an empty string.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoMarkerList& list);

  // Colour times cover, and cover; `markersOver` in shaders.
  vtkRelievoScreenTarget Target;

  vtkIdType GetBytes() const { return this->Target.GetBytes() + this->Markers.GetBytes(); }
  void Release(vtkWindow* window);

private:
  void DrawAll(vtkRelievoFrameContext& context, vtkShaderProgram* program, int count);

  vtkRelievoTextureBuffer Markers;
  vtkRelievoInstancedQuads Quads;
};

#endif
