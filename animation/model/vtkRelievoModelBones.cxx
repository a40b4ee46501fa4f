// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelParts.h"

#include "vtkRelievoSkinNames.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relievo
{
namespace
{
struct Influence
{
  int Bone;
  double Weight;
};

// What was mended about a mesh's weights.
struct WeightFaults
{
  vtkIdType Cut = 0;      // points with more bones than are kept
  double MostCut = 0.;    // largest share of a point's weight that went
  vtkIdType Unfit = 0;    // weights that are not finite, negative, or of points not there
  vtkIdType Rescaled = 0; // points whose weights did not sum to 1
  vtkIdType Boneless = 0; // points of no bone
};

void AddNotes(const std::string& name, int weights, const WeightFaults& faults, Model& model)
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

// The strongest first, at most `weights` of them, which sum to 1.
void Limit(std::vector<Influence>& influences, int weights, WeightFaults& faults)
{
  std::stable_sort(influences.begin(), influences.end(),
    [](const Influence& a, const Influence& b) { return a.Weight > b.Weight; });
  double whole = 0.;
  for (const Influence& influence : influences)
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
    for (const Influence& influence : influences)
    {
      kept += influence.Weight;
    }
    faults.MostCut = std::max(faults.MostCut, 1. - kept / whole);
  }
  for (Influence& influence : influences)
  {
    influence.Weight /= kept;
  }
}

// A list of bones with their nodes and offsets, as field data.
class BoneList
{
public:
  BoneList()
  {
    this->Nodes->SetName(BoneNodeArray);
    this->Offsets->SetName(BoneOffsetArray);
    this->Offsets->SetNumberOfComponents(16);
  }

  int Add(int node, const glm::dmat4& offset)
  {
    double rows[16];
    for (int i = 0; i < 16; ++i)
    {
      rows[i] = offset[i % 4][i / 4];
    }
    this->Nodes->InsertNextValue(node);
    return static_cast<int>(this->Offsets->InsertNextTuple(rows));
  }

  void GiveTo(vtkPolyData* output)
  {
    output->GetFieldData()->AddArray(this->Nodes);
    output->GetFieldData()->AddArray(this->Offsets);
  }

private:
  vtkNew<vtkIntArray> Nodes;
  vtkNew<vtkDoubleArray> Offsets;
};

bool IsFinite(const glm::dmat4& m)
{
  bool finite = true;
  for (int i = 0; i < 16; ++i)
  {
    finite = finite && std::isfinite(m[i / 4][i % 4]);
  }
  return finite;
}

void AddInfluences(
  const aiBone* bone, int number, std::vector<std::vector<Influence>>& points, WeightFaults& faults)
{
  for (unsigned int i = 0; i < bone->mNumWeights; ++i)
  {
    const aiVertexWeight& weight = bone->mWeights[i];
    if (weight.mVertexId >= points.size() || !std::isfinite(weight.mWeight) || weight.mWeight < 0.f)
    {
      ++faults.Unfit;
    }
    else if (weight.mWeight > 0.f)
    {
      std::vector<Influence>& own = points[weight.mVertexId];
      const auto same = std::find_if(
        own.begin(), own.end(), [number](const Influence& other) { return other.Bone == number; });
      if (same != own.end())
      {
        same->Weight += weight.mWeight; // named twice
      }
      else
      {
        own.push_back({ number, weight.mWeight });
      }
    }
  }
}
}

//------------------------------------------------------------------------------
void ReadBones(const aiMesh* mesh, int node, const glm::dmat4& place, const NodeNumbers& numbers,
  int weights, vtkPolyData* output, Model& model)
{
  const std::string name = GetMeshName(mesh, node, model);
  // The points are in their place at rest, so what bones expect lies behind its inverse. A place
  // that flattens has none: the points, all the same, stay.
  const bool flat = std::abs(glm::determinant(glm::dmat3(place))) < 1e-30;
  const glm::dmat4 back = flat ? glm::dmat4(1.) : glm::inverse(place);
  BoneList bones;
  WeightFaults faults;
  std::vector<std::vector<Influence>> points(mesh->mNumVertices);
  for (unsigned int i = 0; i < mesh->mNumBones; ++i)
  {
    const aiBone* bone = mesh->mBones[i];
    const auto found = numbers.find(bone->mName.C_Str());
    const glm::dmat4 offset = ToMatrix(bone->mOffsetMatrix);
    if (found == numbers.end() || !IsFinite(offset))
    {
      model.Notes.push_back("mesh '" + name + "': bone '" + bone->mName.C_Str() +
        (found == numbers.end() ? "' has no node" : "' has an offset that is not finite") +
        ", and is left out");
      continue;
    }
    model.Nodes[static_cast<std::size_t>(found->second)].IsBone = true;
    AddInfluences(bone, bones.Add(found->second, offset * back), points, faults);
  }
  const bool boneless = mesh->mNumBones == 0;
  int own = -1;
  std::size_t most = 1;
  for (std::vector<Influence>& influences : points)
  {
    if (influences.empty())
    {
      own = own < 0 ? bones.Add(node, back) : own;
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
  joints->SetNumberOfTuples(mesh->mNumVertices);
  shares->SetNumberOfComponents(components);
  shares->SetNumberOfTuples(mesh->mNumVertices);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      const bool there = static_cast<std::size_t>(j) < points[i].size();
      const Influence none = { -1, 0. };
      const Influence& influence = there ? points[i][static_cast<std::size_t>(j)] : none;
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
