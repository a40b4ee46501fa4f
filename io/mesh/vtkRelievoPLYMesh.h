// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoPLYMesh.h
 * @brief Converts the tables of a PLY file to a mesh; private to vtkRelievoPLYReader.
 */
#ifndef vtkRelievoPLYMesh_h
#define vtkRelievoPLYMesh_h

#include "vtkRelievoPLYText.h"

class vtkPolyData;

namespace relievo::ply
{
// Fills the mesh, or throws a Refusal.
void MakeMesh(Content& content, vtkPolyData* mesh);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoPLYMesh.h
