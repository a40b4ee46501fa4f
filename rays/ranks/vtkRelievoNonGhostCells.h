// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes copies of other processes' cells (ghosts) from meshes.
#ifndef vtkRelievoNonGhostCells_h
#define vtkRelievoNonGhostCells_h

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnsignedCharArray;

namespace vtkRelievoNonGhostCells
{
// The array that marks copies; null if no cell is a copy.
vtkUnsignedCharArray* GetGhosts(vtkPolyData* mesh);

// The mesh itself if it has no copies. It must have neither vertices nor lines, like all traced
// meshes, so that polygons are its first cells.
vtkSmartPointer<vtkPolyData> Find(vtkPolyData* mesh);
}

#endif
