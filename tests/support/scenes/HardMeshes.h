// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HardMeshes.h
 * @brief Meshes whose edges lie so densely, or so near each other, that shadows go wrong there.
 *
 * About 4 wide, over the ground of the reference scenes, which is at y = 0.
 */
#ifndef relievoTestHardMeshes_h
#define relievoTestHardMeshes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace relievoTest
{
/** 40 upright fins of length 2 whose tops are about a pixel of a picture of 500 wide, or less. */
vtkSmartPointer<vtkPolyData> MakeFins();

/** Mountains of 32 768 triangles, by midpoint displacement: folds in all directions. */
vtkSmartPointer<vtkPolyData> MakeFolds();

/** 1500 arrows along a vortex. */
vtkSmartPointer<vtkPolyData> MakeArrows();

/** A tree: 1093 tubes, each but the last with three thinner ones at its end. */
vtkSmartPointer<vtkPolyData> MakeTree();
}

#endif
