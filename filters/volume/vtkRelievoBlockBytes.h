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
 * The bytes of a surface with so many vertices and faces, and of its polygons, while they are made.
 * `labelBytes` is the size of a label. Two cases take more: normals that cancel out everywhere, and
 * weights of more than 8 labels that were not chosen.
 */
double BytesOfBlocks(vtkIdType vertices, vtkIdType faces, const BlockSettings& settings,
  const BlockMeshSettings& mesh, int labelBytes);
}

#endif
