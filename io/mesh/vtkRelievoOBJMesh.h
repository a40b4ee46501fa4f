// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoOBJMesh.h
 * @brief From the tables of an OBJ file to a mesh; private to vtkRelievoOBJReader.
 */
#ifndef vtkRelievoOBJMesh_h
#define vtkRelievoOBJMesh_h

#include "vtkRelievoOBJText.h"

class vtkPolyData;

namespace relievo::obj
{
// Fills the mesh, and uses the content up. Returns how many cells are left out because of points
// that are not finite.
vtkIdType MakeMesh(Content& content, int typeOfPoints, bool groups, vtkPolyData* mesh);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoOBJMesh.h
