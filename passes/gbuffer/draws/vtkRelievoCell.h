// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a cell of a mesh.
#ifndef vtkRelievoCell_h
#define vtkRelievoCell_h

#include "vtkType.h"

class vtkIdList;
class vtkPolyData;

// Unlike vtkPolyData's own look-up this builds nothing in the mesh, so it is
// thread-safe with one scratch list for each thread, which must outlive the cell.
struct vtkRelievoCell
{
  enum Kinds
  {
    Verts,
    Lines,
    Polys,
    Strips
  };
  int Kind = Polys;
  vtkIdType Count = 0;
  const vtkIdType* Points = nullptr;

  vtkRelievoCell(vtkPolyData* mesh, vtkIdType cell, vtkIdList* scratch);
};

#endif
