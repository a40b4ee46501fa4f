// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Faces of a posed mesh: their normals, and which side is outside.
 */
#ifndef vtkRelievoModelFacets_h
#define vtkRelievoModelFacets_h

#include "vtkRelievoModel.h"

namespace relievo
{
/// Gives the points of each polygon its normal, by which its corners turn left. Polygons share no
/// points.
void GiveFaceNormals(vtkPolyData* mesh);

/// Lets the corners of polygons turn the other way round; each begins with the same.
void TurnFaces(vtkPolyData* mesh);

/// Whether the pose mirrors the mesh from where it is at rest: most of its bones do, or its node.
bool IsMirroredBy(const ModelMesh& mesh, const std::vector<glm::dmat4>& worlds);
}

#endif
