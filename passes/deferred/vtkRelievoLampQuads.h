// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws a rectangle for each lamp, at the front of its sphere and tested against the surfaces'
// depth, and adds what each lights: lamps behind walls cost nothing.
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
  // Draws the surfaces' depth into the target, which was begun and has a depth buffer. Returns what
  // is wrong, in words.
  std::string DrawSurfaces(vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target);

  // Adds the lamps' light to the target, after the surfaces. `bind` sets what the lamps' shader
  // reads. The lamps are those of the context that cast, if there are `shadows`. Returns what is
  // wrong, in words; the number of draw calls is added to `draws`.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoLampList& list,
    const std::string& defines, const std::function<void(vtkShaderProgram*)>& bind,
    vtkRelievoLampShadows* shadows, int& draws);

  vtkIdType GetBytes() const { return this->Rectangles.GetBytes(); }
  void Release(vtkWindow* window);

private:
  vtkRelievoScreenQuad Surfaces; // their depth
  vtkRelievoTextureBuffer Rectangles;
  vtkRelievoInstancedQuads Lamps;
};

#endif
