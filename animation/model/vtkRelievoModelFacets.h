// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Faces of a posed mesh: their normals, and their orientation. */
#ifndef vtkRelievoModelFacets_h
#define vtkRelievoModelFacets_h

#include "vtkRelievoModel.h"

namespace relievo
{
/// Sets the points of each polygon to its normal, about which its corners turn left. Polygons share
/// no points.
void GiveFaceNormals(vtkPolyData* mesh);

/// Reverses the order of polygons' corners, keeping the first.
void TurnFaces(vtkPolyData* mesh);

/// Whether the pose mirrors the mesh relative to rest: most of its bones do, or its node does.
bool IsMirroredBy(const ModelMesh& mesh, const std::vector<glm::dmat4>& worlds);
}

#endif
