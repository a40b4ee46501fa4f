// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoOBJMesh.h
 * @brief Converts the tables of an OBJ file to a mesh; private to vtkRelievoOBJReader.
 */
#ifndef vtkRelievoOBJMesh_h
#define vtkRelievoOBJMesh_h

#include "vtkRelievoOBJText.h"

class vtkPolyData;

namespace relievo::obj
{
// Fills the mesh and consumes the content. Returns the number of cells left out because of
// non-finite points.
vtkIdType MakeMesh(Content& content, int typeOfPoints, bool groups, vtkPolyData* mesh);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoOBJMesh.h
