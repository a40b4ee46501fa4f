// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelScenes.h"

#include "Check.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>

#include <assimp/Exporter.hpp>

#include <cmath>

namespace relievoTest
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
}

//------------------------------------------------------------------------------
aiQuaternion AboutZ(double degrees, float sign)
{
  const auto half = static_cast<float>(degrees * Pi / 360.);
  return { sign * std::cos(half), 0.f, 0.f, sign * std::sin(half) };
}

//------------------------------------------------------------------------------
aiNodeAnim* MakeChannel(const std::string& node, const std::vector<Key>& keys)
{
  auto* channel = new aiNodeAnim;
  channel->mNodeName = node;
  channel->mNumRotationKeys = static_cast<unsigned int>(keys.size());
  channel->mRotationKeys = new aiQuatKey[keys.size()];
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    channel->mRotationKeys[i] = aiQuatKey(keys[i].Time, keys[i].Turn);
  }
  channel->mNumPositionKeys = 1;
  channel->mPositionKeys = new aiVectorKey[1]{ aiVectorKey(0., aiVector3D(0.f, 0.f, 0.f)) };
  channel->mNumScalingKeys = 1;
  channel->mScalingKeys = new aiVectorKey[1]{ aiVectorKey(0., aiVector3D(1.f, 1.f, 1.f)) };
  return channel;
}

//------------------------------------------------------------------------------
std::unique_ptr<aiScene> MakeScene(const std::vector<Key>& keys)
{
  auto scene = std::make_unique<aiScene>();
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  auto* mesh = new aiMesh;
  mesh->mName = "triangle";
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = 3;
  mesh->mVertices = new aiVector3D[3]{ { 1.f, 0.f, 0.f }, { 2.f, 0.f, 0.f }, { 2.f, 0.f, 1.f } };
  mesh->mNumFaces = 1;
  mesh->mFaces = new aiFace[1];
  mesh->mFaces[0].mNumIndices = 3;
  mesh->mFaces[0].mIndices = new unsigned int[3]{ 0, 1, 2 };
  auto* bone = new aiBone;
  bone->mName = "arm";
  bone->mNumWeights = 3;
  bone->mWeights = new aiVertexWeight[3]{ { 0, 1.f }, { 1, 1.f }, { 2, 1.f } };
  mesh->mNumBones = 1;
  mesh->mBones = new aiBone* [1] { bone };
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { mesh };
  scene->mRootNode = new aiNode("root");
  auto* body = new aiNode("body");
  body->mNumMeshes = 1;
  body->mMeshes = new unsigned int[1]{ 0 };
  aiNode* children[2] = { body, new aiNode("arm") };
  scene->mRootNode->addChildren(2, children);
  auto* animation = new aiAnimation;
  animation->mName = "turn";
  animation->mTicksPerSecond = 10.;
  animation->mDuration = keys.empty() ? 0. : keys.back().Time;
  animation->mNumChannels = 1;
  animation->mChannels = new aiNodeAnim* [1] { MakeChannel("arm", keys) };
  scene->mNumAnimations = 1;
  scene->mAnimations = new aiAnimation* [1] { animation };
  return scene;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoModelReader> Read(const aiScene& scene, const std::string& name)
{
  const std::string path = OutputFolder() + "/" + name + ".assbin";
  Assimp::Exporter exporter;
  RELIEVO_CHECK_THAT(exporter.Export(&scene, "assbin", path) == aiReturn_SUCCESS,
    "cannot write " + path + ": " + exporter.GetErrorString());
  auto reader = vtkSmartPointer<vtkRelievoModelReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

//------------------------------------------------------------------------------
vtkPolyData* MeshOf(vtkRelievoModelReader* reader)
{
  return vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(0));
}

//------------------------------------------------------------------------------
double AngleAt(vtkRelievoModelReader* reader, double seconds)
{
  reader->UpdateTimeStep(seconds);
  double p[3];
  MeshOf(reader)->GetPoint(0, p);
  RELIEVO_CHECK_NEAR(std::hypot(p[0], p[1], p[2]), 1., 1e-6, "distance from the joint");
  return std::atan2(p[1], p[0]) * 180. / Pi;
}

//------------------------------------------------------------------------------
std::unique_ptr<aiScene> MakeTwo()
{
  auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  aiAnimation* first = scene->mAnimations[0];
  delete[] scene->mAnimations;
  auto* second = new aiAnimation;
  second->mName = "turn";
  second->mTicksPerSecond = 10.;
  second->mDuration = 10.;
  second->mNumChannels = 1;
  second->mChannels = new aiNodeAnim* [1] { MakeChannel("arm", { { 0., AboutZ(-30.) } }) };
  scene->mNumAnimations = 2;
  scene->mAnimations = new aiAnimation* [2] { first, second };
  return scene;
}
}
