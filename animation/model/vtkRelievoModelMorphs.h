// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Morph targets: shapes between which a mesh changes.
 */
#ifndef vtkRelievoModelMorphs_h
#define vtkRelievoModelMorphs_h

#include "vtkRelievoModel.h"

namespace relievo
{
/// The mesh at rest with targets added by their weights; itself where they add nothing.
vtkSmartPointer<vtkPolyData> MorphMesh(const ModelMesh& mesh, const ModelWeights& weights);
}

#endif
