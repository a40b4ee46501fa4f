// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of meshes that have copies of other processes' cells (ghosts), what is this process's own.
#ifndef vtkRelievoNonGhostCells_h
#define vtkRelievoNonGhostCells_h

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnsignedCharArray;

namespace vtkRelievoNonGhostCells
{
// The array that says which cells are copies; null: none has.
vtkUnsignedCharArray* GetGhosts(vtkPolyData* mesh);

// The mesh itself if it has no copies. It has neither vertices nor lines, as what can be followed:
// polygons are its first cells.
vtkSmartPointer<vtkPolyData> Find(vtkPolyData* mesh);
}

#endif
