// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AssimpPose.h"

#include <assimp/postprocess.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace relievoTest
{
const unsigned int AssimpSteps =
  aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_ImproveCacheLocality;

namespace
{
glm::dmat4 ToMatrix(const aiMatrix4x4& m)
{
  glm::dmat4 result;
  for (unsigned int row = 0; row < 4; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      result[static_cast<int>(column)][static_cast<int>(row)] = m[row][column];
    }
  }
  return result;
}

// The last key at or before the time, and how far on the way to the next.
template <typename Key>
unsigned int FindKey(const Key* keys, unsigned int count, double ticks, double& share)
{
  unsigned int found = 0;
  for (unsigned int i = 0; i < count; ++i)
  {
    found = keys[i].mTime <= ticks ? i : found;
  }
  share = 0.;
  if (found + 1 < count && ticks > keys[found].mTime)
  {
    share = (ticks - keys[found].mTime) / (keys[found + 1].mTime - keys[found].mTime);
  }
  return found;
}

glm::dvec3 Vector(const aiVectorKey* keys, unsigned int count, double ticks)
{
  double share;
  const unsigned int i = FindKey(keys, count, ticks, share);
  const aiVector3D& a = keys[i].mValue;
  const aiVector3D& b = keys[std::min(i + 1, count - 1)].mValue;
  const glm::dvec3 from(a.x, a.y, a.z);
  return from + share * (glm::dvec3(b.x, b.y, b.z) - from);
}

glm::dmat4 Turn(const aiQuatKey* keys, unsigned int count, double ticks)
{
  double share;
  const unsigned int i = FindKey(keys, count, ticks, share);
  const aiQuaternion& a = keys[i].mValue;
  const aiQuaternion& b = keys[std::min(i + 1, count - 1)].mValue;
  const glm::dquat from = glm::normalize(glm::dquat(a.w, a.x, a.y, a.z));
  const glm::dquat to = glm::normalize(glm::dquat(b.w, b.x, b.y, b.z));
  glm::dquat step = glm::conjugate(from) * to;
  step = step.w < 0. ? -step : step;
  const double sine = std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
  const double angle = 2. * std::atan2(sine, step.w);
  if (sine < 1e-15)
  {
    return glm::mat4_cast(from);
  }
  const glm::dvec3 axis = glm::dvec3(step.x, step.y, step.z) / sine;
  return glm::mat4_cast(from * glm::angleAxis(share * angle, axis));
}

glm::dmat4 LocalOf(const aiNode* node, const aiAnimation* animation, double ticks)
{
  for (unsigned int i = 0; animation && i < animation->mNumChannels; ++i)
  {
    const aiNodeAnim* c = animation->mChannels[i];
    if (c->mNodeName == node->mName && c->mNumPositionKeys && c->mNumRotationKeys &&
      c->mNumScalingKeys)
    {
      glm::dmat4 m = Turn(c->mRotationKeys, c->mNumRotationKeys, ticks);
      const glm::dvec3 scale = Vector(c->mScalingKeys, c->mNumScalingKeys, ticks);
      m[0] *= scale.x;
      m[1] *= scale.y;
      m[2] *= scale.z;
      m[3] = glm::dvec4(Vector(c->mPositionKeys, c->mNumPositionKeys, ticks), 1.);
      return m;
    }
  }
  return ToMatrix(node->mTransformation);
}

std::vector<glm::dvec3> PointsOf(const aiScene* scene, const aiNode* node, const aiMesh* mesh,
  const aiAnimation* animation, double ticks)
{
  std::vector<glm::dvec3> sums(mesh->mNumVertices, glm::dvec3(0.));
  std::vector<double> weights(mesh->mNumVertices, 0.);
  const auto at = [mesh](unsigned int i) {
    return glm::dvec4(mesh->mVertices[i].x, mesh->mVertices[i].y, mesh->mVertices[i].z, 1.);
  };
  for (unsigned int i = 0; i < mesh->mNumBones; ++i)
  {
    const aiBone* bone = mesh->mBones[i];
    const aiNode* own = scene->mRootNode->FindNode(bone->mName);
    if (!own)
    {
      continue;
    }
    const glm::dmat4 m = WorldOf(own, animation, ticks) * ToMatrix(bone->mOffsetMatrix);
    for (unsigned int j = 0; j < bone->mNumWeights; ++j)
    {
      const aiVertexWeight& weight = bone->mWeights[j];
      sums[weight.mVertexId] +=
        glm::dvec3(m * at(weight.mVertexId)) * static_cast<double>(weight.mWeight);
      weights[weight.mVertexId] += weight.mWeight;
    }
  }
  const glm::dmat4 world = WorldOf(node, animation, ticks);
  for (unsigned int i = 0; i < mesh->mNumVertices; ++i)
  {
    sums[i] = weights[i] > 0. ? sums[i] / weights[i] : glm::dvec3(world * at(i));
  }
  return sums;
}

void Add(const aiScene* scene, const aiNode* node, const aiAnimation* animation, double ticks,
  std::vector<std::vector<glm::dvec3>>& all)
{
  for (unsigned int i = 0; i < node->mNumMeshes; ++i)
  {
    const aiMesh* mesh = scene->mMeshes[node->mMeshes[i]];
    if (mesh->mNumVertices > 0)
    {
      all.push_back(PointsOf(scene, node, mesh, animation, ticks));
    }
  }
  for (unsigned int i = 0; i < node->mNumChildren; ++i)
  {
    Add(scene, node->mChildren[i], animation, ticks, all);
  }
}
}

//------------------------------------------------------------------------------
glm::dmat4 WorldOf(const aiNode* node, const aiAnimation* animation, double ticks)
{
  const glm::dmat4 local = LocalOf(node, animation, ticks);
  return node->mParent ? WorldOf(node->mParent, animation, ticks) * local : local;
}

//------------------------------------------------------------------------------
std::vector<std::vector<glm::dvec3>> PosedPoints(
  const aiScene* scene, const aiAnimation* animation, double ticks)
{
  std::vector<std::vector<glm::dvec3>> all;
  Add(scene, scene->mRootNode, animation, ticks, all);
  return all;
}

//------------------------------------------------------------------------------
int MostBones(const aiScene* scene)
{
  int most = 0;
  for (unsigned int i = 0; i < scene->mNumMeshes; ++i)
  {
    std::map<unsigned int, int> counts;
    for (unsigned int j = 0; j < scene->mMeshes[i]->mNumBones; ++j)
    {
      const aiBone* bone = scene->mMeshes[i]->mBones[j];
      for (unsigned int k = 0; k < bone->mNumWeights; ++k)
      {
        counts[bone->mWeights[k].mVertexId] += bone->mWeights[k].mWeight > 0.f ? 1 : 0;
      }
    }
    for (const auto& [point, count] : counts)
    {
      most = std::max(most, count);
    }
  }
  return most;
}
}
