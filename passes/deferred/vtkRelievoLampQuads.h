// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws a rectangle for each lamp, at the front of its sphere and tested against the surfaces'
// depth, and adds its light: lamps behind walls cost nothing.
#ifndef vtkRelievoLampQuads_h
#define vtkRelievoLampQuads_h

#include "vtkRelievoInstancedQuads.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoTextureBuffer.h"

#include <functional>
#include <string>

class vtkRelievoLampList;
class vtkRelievoLampShadows;
class vtkRelievoScreenTarget;

class vtkRelievoLampQuads
{
public:
  // Draws the surfaces' depth into the target, which is bound by Begin() and has a depth buffer.
  // Returns an error message, or an empty string.
  std::string DrawSurfaces(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target);

  // Adds the lamps' light to the target, after DrawSurfaces(). `bind` sets the shader's inputs.
  // With `shadows`, the lamps are the context's casting lamps. Returns an error message, or an
  // empty string; adds the number of draw calls to `draws`.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoLampList& list,
    const std::string& defines, const std::function<void(vtkShaderProgram*)>& bind,
    vtkRelievoLampShadows* shadows, int& draws);

  vtkIdType GetBytes() const { return this->Rectangles.GetBytes(); }
  void Release(vtkWindow* window);

private:
  vtkRelievoScreenQuad Surfaces; // draw the surfaces' depth
  vtkRelievoTextureBuffer Rectangles;
  vtkRelievoInstancedQuads Lamps;
};

#endif
