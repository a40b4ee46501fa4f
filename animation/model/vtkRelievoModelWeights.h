// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Converts bones and their weights at points to the arrays of vtkRelievoSkin. */
#ifndef vtkRelievoModelWeights_h
#define vtkRelievoModelWeights_h

#include "vtkRelievoModel.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <string>
#include <vector>

namespace relievo
{
struct ModelInfluence
{
  int Bone;
  double Weight;
};

/// Repairs of a mesh's weights.
struct ModelWeightFaults
{
  vtkIdType Cut = 0;      ///< points with too many bones
  double MostCut = 0.;    ///< largest share of a point's weight that was removed
  vtkIdType Unfit = 0;    ///< weights that are not finite, negative, or of missing points
  vtkIdType Rescaled = 0; ///< points whose weights did not sum to 1
  vtkIdType Boneless = 0; ///< points without a bone
};

/// A list of bones with their nodes and offsets, as field data.
class ModelBones
{
public:
  ModelBones();
  int Add(int node, const glm::dmat4& offset);
  void GiveTo(vtkPolyData* output);

private:
  vtkNew<vtkIntArray> Nodes;
  vtkNew<vtkDoubleArray> Offsets;
};

/// Adds `joints`, `weights` and the bones' field data to the mesh's polydata, with at most
/// `weights` bones per point, the strongest ones. Points without a bone follow `node`, with the
/// matrix `offset`. Adds notes about the faults.
void GiveWeights(const std::string& name, int weights,
  std::vector<std::vector<ModelInfluence>>& points, ModelBones& bones, int node,
  const glm::dmat4& offset, bool boneless, ModelWeightFaults& faults, vtkPolyData* output,
  Model& model);
}

#endif
