// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures drawn in tiles: choices for the whole picture are made in its own NDC.
#ifndef vtkRelievoTiles_h
#define vtkRelievoTiles_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/mat4x4.hpp>

#include <memory>

class vtkRenderer;

// Transforms the NDC of the present tile to those of the whole picture. Identity without tiles.
VTKRELIEVOFRAME_EXPORT glm::dmat4 vtkRelievoGetTileToPicture(vtkRenderer* renderer);

// During its lifetime the renderer draws the rows of its picture from `first` on, counted from the
// bottom, as many as its window has. The window's tile scale must cover the picture.
class VTKRELIEVOFRAME_EXPORT vtkRelievoRows
{
public:
  vtkRelievoRows(vtkRenderer* renderer, int first);
  ~vtkRelievoRows();
  vtkRelievoRows(const vtkRelievoRows&) = delete;
  vtkRelievoRows& operator=(const vtkRelievoRows&) = delete;

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
