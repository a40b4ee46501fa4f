// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Morph targets: shapes that a mesh blends to. */
#ifndef vtkRelievoModelMorphs_h
#define vtkRelievoModelMorphs_h

#include "vtkRelievoModel.h"

namespace relievo
{
/// The mesh at rest with targets added by weight; the mesh itself if they add nothing.
vtkSmartPointer<vtkPolyData> MorphMesh(const ModelMesh& mesh, const ModelWeights& weights);
}

#endif
