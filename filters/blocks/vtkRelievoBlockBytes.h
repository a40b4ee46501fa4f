// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockBytes.h
 * @brief The memory that a surface of blocks takes.
 */
#ifndef vtkRelievoBlockBytes_h
#define vtkRelievoBlockBytes_h

#include "vtkRelievoBlockMesh.h"

namespace relievo
{
/**
 * The bytes of a surface with so many vertices and faces, and of its polygons, while they are made
 * of these labels. Normals that cancel out everywhere take more.
 */
double BytesOfBlocks(vtkIdType vertices, vtkIdType faces, const BlockSettings& settings,
  const BlockMeshSettings& mesh, vtkDataArray* labels);

/** The bytes of so many seams, and of their lines. */
double BytesOfSeams(vtkIdType seams, const BlockSettings& settings);
}

#endif
