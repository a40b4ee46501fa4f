// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelParts.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <memory>
#include <utility>

namespace relievo
{
namespace
{
using Source = vtkGLTFDocumentLoader::Model;
using SourceAnimation = vtkGLTFDocumentLoader::Animation;
using Mode = SourceAnimation::Sampler::InterpolationMode;
using Path = SourceAnimation::Channel::PathType;

// The file's JSON; of a .glb that is its first chunk.
std::string GetText(const std::string& path, bool binary)
{
  std::ifstream file(path, std::ios::binary);
  const auto whole = static_cast<std::size_t>(vtksys::SystemTools::FileLength(path));
  std::size_t length = whole;
  if (binary)
  {
    unsigned char head[20] = {};
    file.read(reinterpret_cast<char*>(head), sizeof(head));
    std::uint32_t chunk = 0;
    for (int i = 3; i >= 0; --i)
    {
      chunk = chunk << 8 | head[12 + i];
    }
    length = std::min<std::size_t>(chunk, whole);
  }
  std::string text(length, ' ');
  file.read(text.data(), static_cast<std::streamsize>(length));
  return text;
}

// What the file says, with its buffers and animations but without what takes long to read.
std::string LoadAnimations(
  const std::string& path, bool binary, vtkGLTFDocumentLoader* loader, Source& result)
{
  if (!loader->LoadModelMetaDataFromFile(path))
  {
    return "VTK does not read the file";
  }
  const std::shared_ptr<Source> source = loader->GetInternalModel();
  std::swap(result.Animations, source->Animations);
  source->Animations.clear();
  source->Meshes.clear();
  source->Images.clear();
  source->Skins.clear();
  std::vector<char> chunk;
  if (binary && !loader->LoadFileBuffer(path, chunk))
  {
    return "VTK finds no buffer in it";
  }
  if (!loader->LoadModelData(chunk))
  {
    return "VTK does not read its buffers";
  }
  std::swap(result.Accessors, source->Accessors);
  std::swap(result.BufferViews, source->BufferViews);
  std::swap(result.Buffers, source->Buffers);
  std::swap(result.Nodes, source->Nodes);
  return "";
}

template <typename List>
bool Holds(const List& list, std::int64_t index)
{
  return index >= 0 && index < static_cast<std::int64_t>(list.size());
}

// The floats of an accessor, or none when they do not lie whole in a buffer.
std::vector<float> GetFloats(const Source& source, std::int64_t number, unsigned int components)
{
  if (!Holds(source.Accessors, number))
  {
    return {};
  }
  const auto& accessor = source.Accessors[static_cast<std::size_t>(number)];
  if (accessor.IsSparse || accessor.NumberOfComponents != components || accessor.Count <= 0 ||
    accessor.ComponentTypeValue != vtkGLTFDocumentLoader::ComponentType::FLOAT ||
    !Holds(source.BufferViews, accessor.BufferView))
  {
    return {};
  }
  const auto& view = source.BufferViews[static_cast<std::size_t>(accessor.BufferView)];
  if (!Holds(source.Buffers, view.Buffer))
  {
    return {};
  }
  const std::vector<char>& buffer = source.Buffers[static_cast<std::size_t>(view.Buffer)];
  const std::int64_t tuple = 4 * static_cast<std::int64_t>(components);
  const std::int64_t stride = view.ByteStride > 0 ? view.ByteStride : tuple;
  const std::int64_t begin = std::int64_t(view.ByteOffset) + accessor.ByteOffset;
  const std::int64_t end = begin + (accessor.Count - 1) * stride + tuple;
  if (begin < 0 || stride < tuple || end > static_cast<std::int64_t>(buffer.size()))
  {
    return {};
  }
  std::vector<float> values(static_cast<std::size_t>(accessor.Count) * components);
  for (int i = 0; i < accessor.Count; ++i)
  {
    std::memcpy(values.data() + static_cast<std::size_t>(i) * components,
      buffer.data() + begin + i * stride, static_cast<std::size_t>(tuple));
  }
  return values;
}

// Gives the track its mode. `slopes`: before, value, after, for each key.
template <typename Value>
bool SetMode(Mode mode, const std::vector<float>& slopes, ModelTrack<Value>& track)
{
  if (mode != Mode::CUBICSPLINE)
  {
    track.Mode = mode == Mode::STEP ? KeyMode::Step : KeyMode::Linear;
    return true;
  }
  const std::size_t keys = track.Times.size();
  constexpr std::size_t parts = sizeof(Value) / sizeof(double);
  if (slopes.size() != 3 * keys * parts)
  {
    return false;
  }
  std::vector<Value> before(keys);
  std::vector<Value> after(keys);
  for (std::size_t i = 0; i < keys; ++i)
  {
    for (std::size_t j = 0; j < parts; ++j)
    {
      const float in = slopes[3 * i * parts + j];
      const float out = slopes[(3 * i + 2) * parts + j];
      if (!std::isfinite(in) || !std::isfinite(out))
      {
        return false;
      }
      before[i][static_cast<int>(j)] = in;
      after[i][static_cast<int>(j)] = out;
    }
  }
  track.Mode = KeyMode::Cubic;
  track.Before = std::move(before);
  track.After = std::move(after);
  return true;
}

// Nodes without a name get one from Assimp, which its versions write in two ways.
NodeNumbers::const_iterator FindNode(const NodeNumbers& numbers, const std::string& name, int place)
{
  const std::string number = std::to_string(place);
  for (const std::string& each : { name, "nodes[" + number + "]", "nodes_" + number })
  {
    const auto found = each.empty() ? numbers.end() : numbers.find(each);
    if (found != numbers.end() || !name.empty())
    {
      return found;
    }
  }
  return numbers.end();
}

// Returns how many tracks could not be given their mode.
int SetModes(
  const Source& source, std::size_t which, const NodeNumbers& numbers, ModelAnimation& animation)
{
  int missed = 0;
  const SourceAnimation& from = source.Animations[which];
  for (const SourceAnimation::Channel& channel : from.Channels)
  {
    if (!Holds(from.Samplers, channel.Sampler) || !Holds(source.Nodes, channel.TargetNode) ||
      channel.TargetPath == Path::WEIGHTS)
    {
      continue;
    }
    const SourceAnimation::Sampler& sampler =
      from.Samplers[static_cast<std::size_t>(channel.Sampler)];
    const std::string& given = source.Nodes[static_cast<std::size_t>(channel.TargetNode)].Name;
    const auto node = FindNode(numbers, given, channel.TargetNode);
    const bool turns = channel.TargetPath == Path::ROTATION;
    const std::vector<float> slopes = sampler.Interpolation == Mode::CUBICSPLINE
      ? GetFloats(source, sampler.Output, turns ? 4 : 3)
      : std::vector<float>();
    bool set = sampler.Interpolation == Mode::LINEAR;
    for (ModelChannel& own : animation.Channels)
    {
      if (!set && node != numbers.end() && own.Node == node->second)
      {
        set = turns ? SetMode(sampler.Interpolation, slopes, own.Rotation)
                    : SetMode(sampler.Interpolation, slopes,
                        channel.TargetPath == Path::SCALE ? own.Scale : own.Position);
      }
    }
    missed += set ? 0 : 1;
  }
  return missed;
}
}

//------------------------------------------------------------------------------
void ReadKeyModes(const std::string& path, const NodeNumbers& numbers, Model& model)
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  const bool binary = extension == ".glb";
  if (model.Animations.empty() || (!binary && extension != ".gltf"))
  {
    return;
  }
  const std::string text = GetText(path, binary);
  if (text.find("\"STEP\"") == std::string::npos &&
    text.find("\"CUBICSPLINE\"") == std::string::npos)
  {
    return;
  }
  vtkNew<vtkCallbackCommand> silence;
  vtkNew<vtkGLTFDocumentLoader> loader;
  loader->AddObserver(vtkCommand::ErrorEvent, silence);
  loader->AddObserver(vtkCommand::WarningEvent, silence);
  Source source;
  std::string wrong;
  try
  {
    wrong = LoadAnimations(path, binary, loader, source);
  }
  catch (const std::exception& error) // of the JSON library that VTK reads glTF with
  {
    wrong = error.what();
  }
  int missed = 0;
  for (ModelAnimation& animation : model.Animations)
  {
    if (wrong.empty() && Holds(source.Animations, animation.Number))
    {
      missed += SetModes(source, static_cast<std::size_t>(animation.Number), numbers, animation);
    }
  }
  if (!wrong.empty())
  {
    model.Notes.push_back("keys of mode STEP or CUBICSPLINE are played as linear: " + wrong);
  }
  else if (missed > 0)
  {
    model.Notes.push_back(std::to_string(missed) +
      " tracks of mode STEP or CUBICSPLINE are played as linear: their keys do not fit");
  }
}
}
