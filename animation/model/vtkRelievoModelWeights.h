// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From bones and their weights at points to the arrays that vtkRelievoSkin takes.
 */
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

/// What was mended about a mesh's weights.
struct ModelWeightFaults
{
  vtkIdType Cut = 0;      ///< points with more bones than are kept
  double MostCut = 0.;    ///< largest share of a point's weight that went
  vtkIdType Unfit = 0;    ///< weights that are not finite, negative, or of points not there
  vtkIdType Rescaled = 0; ///< points whose weights did not sum to 1
  vtkIdType Boneless = 0; ///< points of no bone
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

/// Gives the mesh's polydata `joints`, `weights` and the bones' field data: of each point the
/// strongest bones, at most `weights` of them. Points without a bone follow `node`, which takes
/// them by `offset`. Adds notes about the faults and those that come to it.
void GiveWeights(const std::string& name, int weights,
  std::vector<std::vector<ModelInfluence>>& points, ModelBones& bones, int node,
  const glm::dmat4& offset, bool boneless, ModelWeightFaults& faults, vtkPolyData* output,
  Model& model);
}

#endif
