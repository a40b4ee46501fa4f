// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelFile.h"

#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoFileKind.h"
#include "vtkRelievoGltfFile.h"
#include "vtkRelievoModelBytes.h"
#include "vtkRelievoModelParts.h"
#include "vtkRelievoReaderProcess.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/ProgressHandler.hpp>
#include <assimp/postprocess.h>

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <utility>

namespace relievo
{
namespace
{
// Deeper trees, which no tool writes, overflow the stacks of recursive functions.
constexpr int DeepestTree = 2000;

// For files with impossible counts.
const char* const TooMuch =
  "its counts are too large for memory, expected counts that fit the size of the file; "
  "is it damaged?";

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

// Converts XML with two bytes per character to UTF-8, as Assimp expects; "" for other files. Resets
// the stream to its start.
std::string ReadWideXML(Assimp::IOStream& stream)
{
  unsigned char head[4] = {};
  const std::size_t size = stream.FileSize();
  const bool there = size >= 4 && stream.Read(head, 1, 4) == 4;
  const bool little = head[0] == 0xff && head[1] == 0xfe && head[2] == '<' && head[3] == 0;
  const bool large = head[0] == 0xfe && head[1] == 0xff && head[2] == 0 && head[3] == '<';
  stream.Seek(0, aiOrigin_SET);
  if (!there || !(little || large))
  {
    return "";
  }
  std::vector<unsigned char> bytes(size / 2 * 2);
  stream.Read(bytes.data(), 1, bytes.size());
  stream.Seek(0, aiOrigin_SET);
  const auto unit = [&](std::size_t i) {
    return i + 1 < bytes.size()
      ? unsigned(bytes[i + (little ? 1 : 0)]) << 8 | bytes[i + (little ? 0 : 1)]
      : 0u;
  };
  std::string text;
  for (std::size_t i = 2; i < bytes.size(); i += 2)
  {
    unsigned int code = unit(i);
    if (code >= 0xd800 && code < 0xdc00 && unit(i + 2) >= 0xdc00 && unit(i + 2) < 0xe000)
    {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
      i += 2;
    }
    const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    const unsigned int marks[] = { 0, 0xc0, 0xe0, 0xf0 };
    text += static_cast<char>(marks[more] | code >> (6 * more));
    for (int j = more - 1; j >= 0; --j)
    {
      text += static_cast<char>(0x80 | (code >> (6 * j) & 0x3f));
    }
  }
  return text;
}

// Opens files for Assimp.
class Files : public Assimp::DefaultIOSystem
{
public:
  Files(const std::string& model, const vtkRelievoAllowedFolders& allowed, ModelSources& sources,
    std::vector<std::string>& notes)
    : Model(model)
    , Allowed(allowed)
    , Sources(sources)
    , Notes(notes)
  {
  }

  bool Exists(const char* path) const override
  {
    this->Sources.Add(path);
    return this->DefaultIOSystem::Exists(path) && this->IsAllowed(path);
  }

  Assimp::IOStream* Open(const char* path, const char* mode) override
  {
    if (!this->IsAllowed(path))
    {
      return nullptr;
    }
    this->Sources.Add(path);
    Assimp::IOStream* stream = this->DefaultIOSystem::Open(path, mode);
    const std::string kind =
      vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
    const std::string text = stream && kind == ".dae" ? ReadWideXML(*stream) : "";
    if (text.empty())
    {
      return stream;
    }
    this->DefaultIOSystem::Close(stream);
    auto* bytes = new std::uint8_t[text.size()];
    std::copy(text.begin(), text.end(), bytes);
    return new Assimp::MemoryIOStream(bytes, text.size(), true); // deletes the bytes
  }

private:
  bool IsAllowed(const std::string& path) const
  {
    if (path == this->Model)
    {
      return true;
    }
    std::string obstacle = this->Allowed.FindObstacle(path);
    if (obstacle.empty())
    {
      obstacle = vtkRelievoFileKind::FindInstead(path);
    }
    const std::string note = "read without " + path + ": " + obstacle;
    if (!obstacle.empty() &&
      std::find(this->Notes.begin(), this->Notes.end(), note) == this->Notes.end())
    {
      this->Notes.push_back(note);
    }
    return obstacle.empty();
  }

  std::string Model; // the file that the user names
  const vtkRelievoAllowedFolders& Allowed;
  ModelSources& Sources;
  std::vector<std::string>& Notes;
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

// A node in the walk of the tree: parents before their children.
struct Visit
{
  const aiNode* Node;
  int Parent; // index in the walk; -1 for the root
  int Depth;
};

// Sets parents from the nodes' metadata: some readers of Assimp list bones side by side and let
// each name its parent. Unknown names and cycles are ignored.
void SetParents(std::vector<Visit>& visits)
{
  std::map<const aiNode*, int> places;
  for (std::size_t i = 0; i < visits.size(); ++i)
  {
    places.emplace(visits[i].Node, static_cast<int>(i));
  }
  const auto named = [&](int i) {
    const Visit& visit = visits[static_cast<std::size_t>(i)];
    const auto found = places.find(visit.Node->mParent);
    return found == places.end() ? visit.Parent : found->second;
  };
  std::vector<int> parents(visits.size(), -1);
  std::vector<int> depths(visits.size(), 0);
  for (std::size_t i = 1; i < visits.size(); ++i)
  {
    parents[i] = named(static_cast<int>(i));
    for (int at = parents[i]; at > 0 && depths[i] <= DeepestTree; at = named(at))
    {
      ++depths[i];
    }
    if (depths[i] > DeepestTree)
    {
      return; // a cycle: keeps the tree for all
    }
  }
  for (std::size_t i = 1; i < visits.size(); ++i)
  {
    visits[i].Parent = parents[i];
    visits[i].Depth = depths[i] + 1;
  }
}

// Returns the problem, or "". `hung`: nodes with their new numbers, in the tree's order.
std::string ReadNodes(const aiScene* scene, NodeNumbers& numbers,
  std::vector<std::pair<const aiNode*, int>>& hung, Model& model)
{
  std::vector<Visit> stack = { { scene->mRootNode, -1, 0 } };
  std::vector<Visit> visits;
  while (!stack.empty())
  {
    const Visit visit = stack.back();
    stack.pop_back();
    if (visit.Depth > DeepestTree)
    {
      return "its nodes are nested more than " + std::to_string(DeepestTree) + " deep";
    }
    const int number = static_cast<int>(visits.size());
    visits.push_back(visit);
    for (unsigned int i = visit.Node->mNumChildren; i > 0; --i)
    {
      stack.push_back({ visit.Node->mChildren[i - 1], number, visit.Depth + 1 });
    }
  }
  SetParents(visits);
  // Parents get lower numbers than their children.
  std::vector<std::size_t> order(visits.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&visits](std::size_t a, std::size_t b) { return visits[a].Depth < visits[b].Depth; });
  std::vector<int> numberOf(visits.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    numberOf[order[i]] = static_cast<int>(i);
  }
  int unfit = 0;
  for (const std::size_t i : order)
  {
    const Visit& visit = visits[i];
    ModelNode node;
    node.Name = visit.Node->mName.C_Str();
    node.Parent = visit.Parent < 0 ? -1 : numberOf[static_cast<std::size_t>(visit.Parent)];
    node.Rest = ToMatrix(visit.Node->mTransformation);
    if (!IsFinite(node.Rest))
    {
      node.Rest = glm::dmat4(1.);
      ++unfit;
    }
    model.Nodes.push_back(node);
  }
  for (std::size_t i = 0; i < visits.size(); ++i)
  {
    numbers.emplace(visits[i].Node->mName.C_Str(), numberOf[i]);
    hung.emplace_back(visits[i].Node, numberOf[i]);
  }
  if (unfit > 0)
  {
    model.Notes.push_back(
      std::to_string(unfit) + " nodes have a matrix that is not finite; they stay in place");
  }
  return "";
}

// FBX defines for each node how it inherits its parent's scale, but Assimp always multiplies
// matrices. Notes the nodes that are misplaced by that: those below a scaled parent that should not
// inherit.
void NoteScales(const aiScene* scene, const std::vector<std::pair<const aiNode*, int>>& hung,
  std::vector<std::string>& notes)
{
  constexpr std::int32_t takesNone = 2; // Rrs
  constexpr float least = 1e-3f;
  // Assimp may split one node of the file into a chain whose names contain this part.
  const std::string part = "_$AssimpFbx$_";
  const auto isPartOf = [&part](const aiNode* node, const std::string& name) {
    return std::string(node->mName.C_Str()).rfind(name + part, 0) == 0;
  };
  const auto isScaled = [scene](const aiNode* node) {
    aiVector3D scale;
    aiVector3D place;
    aiQuaternion turn;
    node->mTransformation.Decompose(scale, turn, place);
    const auto isOff = [](const aiVector3D& v) { return !v.Equal(aiVector3D(1.f), least); };
    bool scaled = isOff(scale);
    for (unsigned int i = 0; i < scene->mNumAnimations; ++i)
    {
      const aiAnimation* animation = scene->mAnimations[i];
      for (unsigned int j = 0; j < animation->mNumChannels; ++j)
      {
        const aiNodeAnim* channel = animation->mChannels[j];
        scaled = scaled ||
          (channel->mNodeName == node->mName &&
            std::any_of(channel->mScalingKeys, channel->mScalingKeys + channel->mNumScalingKeys,
              [&isOff](const aiVectorKey& key) { return isOff(key.mValue); }));
      }
    }
    return scaled;
  };
  for (const auto& [node, number] : hung)
  {
    std::int32_t manner = 0;
    if (!node->mMetaData || !node->mMetaData->Get("InheritType", manner) || manner != takesNone)
    {
      continue;
    }
    const std::string name = node->mName.C_Str();
    const aiNode* parent = node->mParent;
    while (parent && isPartOf(parent, name))
    {
      parent = parent->mParent;
    }
    const std::string above = parent ? parent->mName.C_Str() : "";
    bool scaled = parent && isScaled(parent);
    for (const aiNode* at = parent ? parent->mParent : nullptr; at && isPartOf(at, above);
         at = at->mParent)
    {
      scaled = scaled || isScaled(at);
    }
    if (scaled)
    {
      notes.push_back("node '" + name + "' is to leave out the scale of its parent '" + above +
        "' (InheritType 2), and is drawn with it; bake the scale before exporting");
    }
  }
}

// Assimp's postprocessing trusts all indices. Returns the problem, or "". Weights of missing points
// lose their value, and are counted with those.
std::string CheckMeshes(const aiScene* scene)
{
  for (unsigned int i = 0; i < scene->mNumMeshes; ++i)
  {
    const aiMesh* mesh = scene->mMeshes[i];
    const unsigned int count = mesh->mNumVertices;
    for (unsigned int j = 0; j < mesh->mNumFaces; ++j)
    {
      const aiFace& face = mesh->mFaces[j];
      const auto strange = std::find_if(face.mIndices, face.mIndices + face.mNumIndices,
        [count](unsigned int point) { return point >= count; });
      if (strange != face.mIndices + face.mNumIndices)
      {
        return "mesh " + std::to_string(i) + " has a face of point " + std::to_string(*strange) +
          ", and only " + std::to_string(count) + " points";
      }
    }
    for (unsigned int j = 0; j < mesh->mNumBones; ++j)
    {
      aiBone* bone = mesh->mBones[j];
      for (unsigned int k = 0; k < bone->mNumWeights; ++k)
      {
        if (bone->mWeights[k].mVertexId >= count)
        {
          bone->mWeights[k] = aiVertexWeight(0, std::numeric_limits<float>::quiet_NaN());
        }
      }
    }
  }
  return "";
}

std::string Import(const std::string& path, const vtkRelievoAllowedFolders& allowed, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model)
{
  Assimp::Importer importer;
  // The importer deletes both handlers.
  importer.SetIOHandler(new Files(path, allowed, sources, model.Notes));
  importer.SetProgressHandler(new Handler(progress));
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene)
  {
    const std::string unfit = CheckMeshes(scene);
    if (!unfit.empty())
    {
      return unfit;
    }
    scene = importer.ApplyPostProcessing(
      aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_ImproveCacheLocality);
  }
  if (!scene || !scene->mRootNode)
  {
    const std::string why = importer.GetErrorString();
    if (why == std::bad_alloc().what() || why == std::bad_array_new_length().what())
    {
      return TooMuch;
    }
    return why.empty() ? "Assimp does not read it" : why;
  }
  if (scene->mNumMeshes == 0 && scene->mNumAnimations == 0)
  {
    return "it holds no meshes and no animations";
  }
  NodeNumbers numbers;
  std::vector<std::pair<const aiNode*, int>> hung;
  const std::string error = ReadNodes(scene, numbers, hung, model);
  if (!error.empty())
  {
    return error;
  }
  NoteScales(scene, hung, model.Notes);
  std::vector<glm::dmat4> locals;
  for (const ModelNode& node : model.Nodes)
  {
    locals.push_back(node.Rest);
  }
  const std::vector<glm::dmat4> worlds = GetWorldMatrices(model.Nodes, locals);
  for (std::size_t i = 0; i < hung.size(); ++i)
  {
    const auto [node, number] = hung[i];
    for (unsigned int j = 0; j < node->mNumMeshes; ++j)
    {
      if (node->mMeshes[j] < scene->mNumMeshes)
      {
        ReadMesh(scene, scene->mMeshes[node->mMeshes[j]], number,
          worlds[static_cast<std::size_t>(number)], numbers, weights, model);
      }
    }
    progress(0.9 + 0.1 * static_cast<double>(i) / static_cast<double>(hung.size()));
  }
  ReadAnimations(scene, numbers, model);
  return "";
}

std::string ReadHere(const std::string& path, const std::vector<std::string>& folders, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model)
{
  sources.Add(path);
  const vtkRelievoAllowedFolders allowed(path, folders);
  if (GetIsGltfExtension(path))
  {
    ReadGltf(path, allowed, weights, progress, sources, model);
    return "";
  }
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    return "there is no such file";
  }
  const std::string instead = vtkRelievoFileKind::FindInstead(path);
  return instead.empty() ? Import(path, allowed, weights, progress, sources, model)
                         : "expected a file, but " + instead;
}

struct Question
{
  std::string Path;
  std::vector<std::string> Folders;
  int Weights = 0;
};

template <typename Visit>
void VisitFields(Question& question, Visit&& visit)
{
  visit(question.Path, question.Folders, question.Weights);
}

struct Answer
{
  std::string Error;
  ModelSources Sources;
  Model Content;
};

template <typename Visit>
void VisitFields(Answer& answer, Visit&& visit)
{
  visit(answer.Error, answer.Sources, answer.Content);
}

// Runs in the process of the file.
void AnswerQuestion(const Question& asked, const vtkRelievoReaderProcess::Say& say, Answer& made)
{
  try
  {
    made.Error = ReadHere(
      asked.Path, asked.Folders, asked.Weights, [&say](double share) { return say("", share); },
      made.Sources, made.Content);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error) // from Assimp and glTF
  {
    made.Error = error.what();
  }
  if (!made.Error.empty())
  {
    made.Content = Model();
  }
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
std::string ReadModel(const std::string& path, const std::vector<std::string>& folders, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model)
{
  Answer made;
  std::string failure;
  try
  {
    failure = vtkRelievoReaderProcess::Do<AnswerQuestion>(
      Question{ path, folders, weights },
      [&progress](const std::string&, double share) { return progress(share); }, made);
  }
  catch (const std::bad_alloc&)
  {
    made = Answer();
    made.Error = TooMuch;
  }
  if (failure.empty() && !IsConsistent(made.Content))
  {
    failure = "crashed: its result is damaged";
  }
  sources = made.Sources;
  if (!failure.empty())
  {
    made = Answer();
    made.Error =
      std::string("the reader (") + (GetIsGltfExtension(path) ? "glTF" : "Assimp") + ") " + failure;
    sources = ModelSources();
    sources.Add(path); // not read again while unchanged
  }
  model = std::move(made.Content);
  return made.Error;
}

//------------------------------------------------------------------------------
bool GetIsModelExtension(const std::string& path)
{
  const std::string extension = vtksys::SystemTools::GetFilenameLastExtension(path);
  try
  {
    return GetIsGltfExtension(path) ||
      (extension.size() > 1 && Assimp::Importer().IsExtensionSupported(extension));
  }
  catch (const std::exception&)
  {
    return false;
  }
}
}
