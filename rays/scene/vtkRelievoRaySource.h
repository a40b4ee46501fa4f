// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A placed mesh's origin in the user's data.
#ifndef vtkRelievoRaySource_h
#define vtkRelievoRaySource_h

#include "vtkActor.h"
#include "vtkIdTypeArray.h"
#include "vtkRelievoMeshTree.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <memory>

class vtkDataArray;

struct vtkRelievoRaySource
{
  int Prop = -1;
  vtkWeakPointer<vtkActor> Actor;  // in a renderer
  int Added = -1;                  // index in Data
  vtkDataArray* Normals = nullptr; // none: geometric normals
  bool OfCells = false;
  vtkIdTypeArray* Cells = nullptr; // indices of the mesh's cells in the data; none: equal
  vtkIdTypeArray* Points = nullptr;
  // The user's ids of the mesh's points, which identify them for FindMoved; null: `Points` does.
  vtkSmartPointer<vtkIdTypeArray> Ids;
  vtkIdType PointsOfPlace = 0; // points per glyph, if glyphs' places are merged into one mesh
  bool IsOpaque = true;        // drawn as opaque by VTK
  std::shared_ptr<vtkRelievoMeshTree> Tree; // in a file

  vtkIdTypeArray* GetIds() const { return this->Ids ? this->Ids.Get() : this->Points; }
};

#endif
