// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelFile.h"

#include "vtkRelievoModelParts.h"

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/postprocess.h>

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <exception>

namespace relievo
{
namespace
{
// Deeper trees than any tool writes overflow the stacks of those that walk them by calls.
constexpr int DeepestTree = 2000;

class Handler : public Assimp::ProgressHandler
{
public:
  explicit Handler(const std::function<bool(double)>& progress)
    : Progress(progress)
  {
  }

  bool Update(float share) override { return this->Progress(share < 0.f ? 0. : 0.9 * share); }

private:
  const std::function<bool(double)>& Progress;
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

// Parents first. Returns what is wrong, or "".
std::string ReadNodes(
  const aiScene* scene, NodeNumbers& numbers, std::vector<const aiNode*>& sources, Model& model)
{
  struct Entry
  {
    const aiNode* Node;
    int Parent;
    int Depth;
  };
  std::vector<Entry> stack = { { scene->mRootNode, -1, 0 } };
  int unfit = 0;
  while (!stack.empty())
  {
    const Entry entry = stack.back();
    stack.pop_back();
    if (entry.Depth > DeepestTree)
    {
      return "its nodes are nested more than " + std::to_string(DeepestTree) + " deep";
    }
    const int number = static_cast<int>(model.Nodes.size());
    ModelNode node;
    node.Name = entry.Node->mName.C_Str();
    node.Parent = entry.Parent;
    node.Rest = ToMatrix(entry.Node->mTransformation);
    if (!IsFinite(node.Rest))
    {
      node.Rest = glm::dmat4(1.);
      ++unfit;
    }
    numbers.emplace(node.Name, number);
    model.Nodes.push_back(node);
    sources.push_back(entry.Node);
    for (unsigned int i = entry.Node->mNumChildren; i > 0; --i)
    {
      stack.push_back({ entry.Node->mChildren[i - 1], number, entry.Depth + 1 });
    }
  }
  if (unfit > 0)
  {
    model.Notes.push_back(
      std::to_string(unfit) + " nodes have a matrix that is not finite; they stay in place");
  }
  return "";
}

std::string Import(
  const std::string& path, int weights, const std::function<bool(double)>& progress, Model& model)
{
  // Declared before the importer, which lets go of it last.
  Handler handler(progress);
  Assimp::Importer importer;
  importer.SetProgressHandler(&handler);
  const aiScene* scene = importer.ReadFile(
    path, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_ImproveCacheLocality);
  importer.SetProgressHandler(nullptr);
  if (!scene || !scene->mRootNode)
  {
    const std::string why = importer.GetErrorString();
    return why.empty() ? "Assimp does not read it" : why;
  }
  if (scene->mNumMeshes == 0 && scene->mNumAnimations == 0)
  {
    return "it holds no meshes and no animations";
  }
  NodeNumbers numbers;
  std::vector<const aiNode*> sources;
  const std::string wrong = ReadNodes(scene, numbers, sources, model);
  if (!wrong.empty())
  {
    return wrong;
  }
  std::vector<glm::dmat4> locals;
  for (const ModelNode& node : model.Nodes)
  {
    locals.push_back(node.Rest);
  }
  const std::vector<glm::dmat4> worlds = GetWorldMatrices(model.Nodes, locals);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    for (unsigned int j = 0; j < sources[i]->mNumMeshes; ++j)
    {
      const unsigned int mesh = sources[i]->mMeshes[j];
      if (mesh < scene->mNumMeshes)
      {
        ReadMesh(
          scene, scene->mMeshes[mesh], static_cast<int>(i), worlds[i], numbers, weights, model);
      }
    }
    progress(0.9 + 0.1 * static_cast<double>(i) / static_cast<double>(sources.size()));
  }
  ReadAnimations(scene, numbers, model);
  return "";
}
}

//------------------------------------------------------------------------------
std::vector<glm::dmat4> GetWorldMatrices(
  const std::vector<ModelNode>& nodes, const std::vector<glm::dmat4>& locals)
{
  std::vector<glm::dmat4> worlds(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const int parent = nodes[i].Parent;
    worlds[i] = parent < 0 ? locals[i] : worlds[static_cast<std::size_t>(parent)] * locals[i];
  }
  return worlds;
}

//------------------------------------------------------------------------------
std::string ReadModel(
  const std::string& path, int weights, const std::function<bool(double)>& progress, Model& model)
{
  model = Model();
  std::string wrong;
  try
  {
    if (!vtksys::SystemTools::FileExists(path, true))
    {
      wrong = "there is no such file";
    }
    else
    {
      wrong = Import(path, weights, progress, model);
    }
  }
  catch (const std::exception& error) // of Assimp, and memory
  {
    wrong = error.what();
  }
  if (!wrong.empty())
  {
    model = Model();
  }
  return wrong;
}

//------------------------------------------------------------------------------
bool GetIsModelExtension(const std::string& path)
{
  const std::string extension = vtksys::SystemTools::GetFilenameLastExtension(path);
  try
  {
    return extension.size() > 1 && Assimp::Importer().IsExtensionSupported(extension);
  }
  catch (const std::exception&)
  {
    return false;
  }
}
}
