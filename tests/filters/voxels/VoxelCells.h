// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelCells.h
 * @brief Shared by the tests of voxel shells: a grid, and the cells that a filter finds.
 */
#ifndef relievoTestVoxelCells_h
#define relievoTestVoxelCells_h

#include <vtkRelievoVoxelShell.h>

#include <vector>

class vtkDataObject;

namespace relievoTest
{
using Cells = std::vector<unsigned char>;

/** Around bodies of about 1, with so many cells each way; not symmetric to them. */
void SetGrid(vtkRelievoVoxelShell* filter, int count = 40);

/** Updates the filter, which must succeed; its mask. */
Cells CellsOf(vtkRelievoVoxelShell* filter);

/** The cells of data in that grid. */
Cells CellsOf(vtkDataObject* data, int method = vtkRelievoVoxelShell::PARITY);

/** How many cells differ; very many if there are not as many. */
vtkIdType Differences(const Cells& a, const Cells& b);
}

#endif
