// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The opaque meshes of all of a renderer's visible props, those outside the view included.
#ifndef vtkRelievoOpaqueMeshes_h
#define vtkRelievoOpaqueMeshes_h

#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoPlacedMesh.h"

#include <vector>

class vtkRenderer;

class vtkRelievoOpaqueMeshes
{
public:
  // The meshes as they are now: their places and points are valid until a pipeline changes.
  std::vector<vtkRelievoPlacedMesh> Find(vtkRenderer* renderer);

  // Props with meshes that Find could not follow triangle by triangle.
  int GetNumberOfPropsLeftOut() const { return this->LeftOut; }

  // Of a mesh that was left out for them; 0: there is none.
  vtkIdType GetTooManyTriangles() const { return this->TooManyTriangles; }

private:
  vtkRelievoGlyphPlaces Glyphs; // what is known of them from before
  int LeftOut = 0;
  vtkIdType TooManyTriangles = 0;
};

#endif
