// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelParts.h"

#include "vtkRelievoModelWeights.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
bool IsFinite(const glm::dmat4& m)
{
  bool finite = true;
  for (int i = 0; i < 16; ++i)
  {
    finite = finite && std::isfinite(m[i / 4][i % 4]);
  }
  return finite;
}

// FBX's first transform of a mesh's points (GeometricTranslation, -Rotation and -Scaling):
// Assimp makes nodes of it, parents of the mesh's.
glm::dmat4 GetGeometric(const Model& model, int node)
{
  const auto isPart = [&model](int at) {
    return model.Nodes[static_cast<std::size_t>(at)].Name.find("_$AssimpFbx$_Geometric") !=
      std::string::npos;
  };
  glm::dmat4 all(1.);
  int at = isPart(node) ? node : model.Nodes[static_cast<std::size_t>(node)].Parent;
  for (; at >= 0 && isPart(at); at = model.Nodes[static_cast<std::size_t>(at)].Parent)
  {
    all = model.Nodes[static_cast<std::size_t>(at)].Rest * all;
  }
  return all;
}

void AddInfluences(const aiBone* bone, int number, std::vector<std::vector<ModelInfluence>>& points,
  ModelWeightFaults& faults)
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
      std::vector<ModelInfluence>& own = points[weight.mVertexId];
      const auto same = std::find_if(own.begin(), own.end(),
        [number](const ModelInfluence& other) { return other.Bone == number; });
      if (same != own.end())
      {
        same->Weight += weight.mWeight; // the bone is listed twice
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
  // The points are transformed to rest, so bones need its inverse first. A flattening transform has
  // none; the points then stay in place.
  const bool flat = std::abs(glm::determinant(glm::dmat3(place))) < 1e-30;
  const glm::dmat4 back = flat ? glm::dmat4(1.) : glm::inverse(place);
  // A cluster's Transform is that of the mesh's node when it was bound.
  const glm::dmat4 toBind = GetGeometric(model, node) * back;
  ModelBones bones;
  ModelWeightFaults faults;
  std::vector<std::vector<ModelInfluence>> points(mesh->mNumVertices);
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
    AddInfluences(bone, bones.Add(found->second, offset * toBind), points, faults);
  }
  GiveWeights(
    name, weights, points, bones, node, back, mesh->mNumBones == 0, faults, output, model);
}
}
