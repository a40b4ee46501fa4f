// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockBytes.h
 * @brief The memory needed to make a surface of blocks.
 */
#ifndef vtkRelievoBlockBytes_h
#define vtkRelievoBlockBytes_h

#include "vtkRelievoBlockMesh.h"

namespace relievo
{
/**
 * Bytes needed to make a surface with so many vertices and faces, and its polygons, from these
 * labels. Normals that cancel out everywhere need more.
 */
double BytesOfBlocks(vtkIdType vertices, vtkIdType faces, const BlockSettings& settings,
  const BlockMeshSettings& mesh, vtkDataArray* labels);

/** Bytes needed for so many seams and their lines. */
double BytesOfSeams(vtkIdType seams, const BlockSettings& settings);
}

#endif
