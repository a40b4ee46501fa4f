// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelWeights.h"

#include "vtkRelievoSkinNames.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relievo
{
namespace
{
void AddNotes(const std::string& name, int weights, const ModelWeightFaults& faults, Model& model)
{
  const auto add = [&](vtkIdType count, const std::string& what) {
    if (count > 0)
    {
      model.Notes.push_back("mesh '" + name + "': " + std::to_string(count) + " " + what);
    }
  };
  std::ostringstream cut;
  cut << "points have more than " << weights << " bones; the strongest are kept, at most "
      << 100. * faults.MostCut << " % of a point's weight is cut";
  add(faults.Cut, cut.str());
  add(faults.Unfit, "weights are not finite, negative, or of points that are not there");
  add(faults.Rescaled, "points have weights that do not sum to 1, and are rescaled");
  add(faults.Boneless, "points have no bone, and follow the mesh's node");
}

// Keeps the strongest bones, at most `weights`, with a sum of 1.
void Limit(std::vector<ModelInfluence>& influences, int weights, ModelWeightFaults& faults)
{
  std::stable_sort(influences.begin(), influences.end(),
    [](const ModelInfluence& a, const ModelInfluence& b) { return a.Weight > b.Weight; });
  double whole = 0.;
  for (const ModelInfluence& influence : influences)
  {
    whole += influence.Weight;
  }
  faults.Rescaled += std::abs(whole - 1.) > 1e-3 ? 1 : 0;
  double kept = whole;
  if (influences.size() > static_cast<std::size_t>(weights))
  {
    ++faults.Cut;
    influences.resize(static_cast<std::size_t>(weights));
    kept = 0.;
    for (const ModelInfluence& influence : influences)
    {
      kept += influence.Weight;
    }
    faults.MostCut = std::max(faults.MostCut, 1. - kept / whole);
  }
  for (ModelInfluence& influence : influences)
  {
    influence.Weight /= kept;
  }
}
}

//------------------------------------------------------------------------------
ModelBones::ModelBones()
{
  this->Nodes->SetName(BoneNodeArray);
  this->Offsets->SetName(BoneOffsetArray);
  this->Offsets->SetNumberOfComponents(16);
}

//------------------------------------------------------------------------------
int ModelBones::Add(int node, const glm::dmat4& offset)
{
  double rows[16];
  for (int i = 0; i < 16; ++i)
  {
    rows[i] = offset[i % 4][i / 4];
  }
  this->Nodes->InsertNextValue(node);
  return static_cast<int>(this->Offsets->InsertNextTuple(rows));
}

//------------------------------------------------------------------------------
void ModelBones::GiveTo(vtkPolyData* output)
{
  output->GetFieldData()->AddArray(this->Nodes);
  output->GetFieldData()->AddArray(this->Offsets);
}

//------------------------------------------------------------------------------
void GiveWeights(const std::string& name, int weights,
  std::vector<std::vector<ModelInfluence>>& points, ModelBones& bones, int node,
  const glm::dmat4& offset, bool boneless, ModelWeightFaults& faults, vtkPolyData* output,
  Model& model)
{
  int own = -1;
  std::size_t most = 1;
  for (std::vector<ModelInfluence>& influences : points)
  {
    if (influences.empty())
    {
      own = own < 0 ? bones.Add(node, offset) : own;
      influences.push_back({ own, 1. });
      faults.Boneless += boneless ? 0 : 1;
      continue;
    }
    Limit(influences, weights, faults);
    most = std::max(most, influences.size());
  }
  vtkNew<vtkIntArray> joints;
  joints->SetName(JointsArray);
  vtkNew<vtkFloatArray> shares;
  shares->SetName(WeightsArray);
  const int components = static_cast<int>(most);
  joints->SetNumberOfComponents(components);
  joints->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  shares->SetNumberOfComponents(components);
  shares->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      const bool there = static_cast<std::size_t>(j) < points[i].size();
      const ModelInfluence none = { -1, 0. };
      const ModelInfluence& influence = there ? points[i][static_cast<std::size_t>(j)] : none;
      joints->SetTypedComponent(static_cast<vtkIdType>(i), j, influence.Bone);
      shares->SetTypedComponent(static_cast<vtkIdType>(i), j, static_cast<float>(influence.Weight));
    }
  }
  output->GetPointData()->AddArray(joints);
  output->GetPointData()->AddArray(shares);
  bones.GiveTo(output);
  AddNotes(name, weights, faults, model);
}
}
