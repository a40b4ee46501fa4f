// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The opaque meshes of all visible props of a renderer, those outside the view included.
#ifndef vtkRelievoOpaqueMeshes_h
#define vtkRelievoOpaqueMeshes_h

#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoPlacedMesh.h"

#include <vector>

class vtkRenderer;

class vtkRelievoOpaqueMeshes
{
public:
  // The present meshes: their positions and points are valid until a pipeline changes.
  std::vector<vtkRelievoPlacedMesh> Find(vtkRenderer* renderer);

  // Number of props, but for shadow catchers, whose meshes Find could not read as triangles.
  int GetNumberOfPropsLeftOut() const { return this->LeftOut; }

  // Number of triangles of a mesh that was left out for its size; 0 if there is none.
  vtkIdType GetTooManyTriangles() const { return this->TooManyTriangles; }

private:
  vtkRelievoGlyphPlaces Glyphs; // cached positions
  int LeftOut = 0;
  vtkIdType TooManyTriangles = 0;
};

#endif
