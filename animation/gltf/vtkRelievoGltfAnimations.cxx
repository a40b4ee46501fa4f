// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfParts.h"
#include "vtkRelievoModelNames.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
using namespace gltf;

enum Path : std::size_t
{
  Translation,
  Rotation,
  Scale,
  Weights
};

const GltfKind TimesKind = { { "SCALAR" }, { Float } };
const GltfKind NumbersKind = { { "VEC3" }, { Float } };
const GltfKind TurnsKind = { { "VEC4" }, { Float, Byte, UnsignedByte, Short, UnsignedShort },
  true };
const GltfKind MorphWeightsKind = { { "SCALAR" },
  { Float, Byte, UnsignedByte, Short, UnsignedShort }, true };

// A sampler's keys: `parts` numbers per key, and three times as many for splines.
struct Keys
{
  KeyMode Mode = KeyMode::Linear;
  const GltfNumbers* Times = nullptr;
  const GltfNumbers* Values = nullptr;
  std::size_t Parts = 0;

  // For a spline: 0 the slope before, 1 the value, 2 the slope after.
  const double* At(std::size_t key, std::size_t which) const
  {
    const std::size_t each = this->Mode == KeyMode::Cubic ? 3 : 1;
    return this->Values->Values.data() + this->Parts * (each * key + (each == 3 ? which : 0));
  }
};

class AnimationMaker
{
public:
  AnimationMaker(GltfDocument& document, const GltfNodes& nodes, Model& result)
    : Document(document)
    , Nodes(nodes)
    , Result(result)
  {
  }

  void Read(std::size_t which)
  {
    const GltfValue value = this->Document.Get("animations").At(which);
    ModelAnimation animation;
    animation.Name = GetFreeName(value.Get("name").GetText(""), this->Result.Animations);
    this->Channels.clear();
    const GltfValue channels = value.Get("channels");
    for (std::size_t i = 0; i < channels.GetSize(); ++i)
    {
      this->ReadChannel(value, channels.At(i), animation);
    }
    this->Document.Forget();
    std::vector<double>& times = animation.KeyTimes;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
    {
      this->Result.Notes.push_back(
        "animation '" + animation.Name + "' moves nothing, and is left out");
      return;
    }
    animation.Start = times.front();
    animation.End = times.back();
    this->Result.Animations.push_back(std::move(animation));
  }

private:
  //----------------------------------------------------------------------------
  void ReadChannel(const GltfValue& owner, const GltfValue& channel, ModelAnimation& animation)
  {
    const GltfValue samplers = owner.Get("samplers");
    const int sampler = channel.Get("sampler").GetIndex("samplers", samplers.GetSize());
    const GltfValue target = channel.Get("target");
    const int place = target.Get("node").GetIndex("nodes", this->Nodes.Numbers.size());
    if (sampler < 0)
    {
      channel.Get("sampler").FailExpecting("the number of a sampler");
    }
    if (place < 0 || target.Get("path").GetText("") == "pointer")
    {
      this->Result.Notes.push_back(channel.GetPlace() + " moves no node, and is left out");
      return;
    }
    if (!target.Get("path").IsThere())
    {
      target.Get("path").FailExpecting("translation, rotation, scale or weights");
    }
    const std::size_t path =
      target.Get("path").GetWord({ "translation", "rotation", "scale", "weights" });
    const int node = this->Nodes.Get(static_cast<std::size_t>(place));
    if (node < 0)
    {
      return; // a node of another scene
    }
    std::size_t parts = path == Rotation ? 4 : 3;
    if (path == Weights)
    {
      parts = static_cast<std::size_t>(node) < this->Result.Weights.size()
        ? this->Result.Weights[static_cast<std::size_t>(node)].size()
        : 0;
      if (parts == 0)
      {
        this->Result.Notes.push_back(
          channel.GetPlace() + " moves morph targets of a node without any, and is left out");
        return;
      }
    }
    const Keys keys = this->ReadKeys(samplers.At(static_cast<std::size_t>(sampler)), path, parts);
    const std::vector<double>& times = keys.Times->Values;
    animation.KeyTimes.insert(animation.KeyTimes.end(), times.begin(), times.end());
    const auto toVector = [](const double* v) { return glm::dvec3(v[0], v[1], v[2]); };
    switch (path)
    {
      case Translation:
        Fill(keys, toVector, this->GetChannel(node, animation).Position);
        break;
      case Scale:
        Fill(keys, toVector, this->GetChannel(node, animation).Scale);
        break;
      case Rotation:
      {
        ModelTrack<glm::dvec4>& track = this->GetChannel(node, animation).Rotation;
        Fill(
          keys, [](const double* v) { return glm::dvec4(v[0], v[1], v[2], v[3]); }, track);
        for (glm::dvec4& turn : track.Values)
        {
          const double length = glm::length(turn);
          if (length < 1e-12)
          {
            samplers.At(static_cast<std::size_t>(sampler))
              .Get("output")
              .Fail("has a rotation without length, expected quaternions of length 1");
          }
          turn = keys.Mode == KeyMode::Cubic ? turn : turn / length;
        }
        break;
      }
      default:
        animation.Morphs.push_back({ node, {} });
        Fill(
          keys, [parts](const double* v) { return ModelWeights(v, parts); },
          animation.Morphs.back().Weights);
    }
  }

  //----------------------------------------------------------------------------
  Keys ReadKeys(const GltfValue& sampler, std::size_t path, std::size_t parts)
  {
    Keys keys;
    keys.Parts = parts;
    const std::size_t mode =
      sampler.Get("interpolation").GetWord({ "LINEAR", "STEP", "CUBICSPLINE" });
    keys.Mode = mode == 0 ? KeyMode::Linear : mode == 1 ? KeyMode::Step : KeyMode::Cubic;
    const GltfValue input = sampler.Get("input");
    const GltfValue output = sampler.Get("output");
    keys.Times = &this->Document.GetNumbers(input, TimesKind);
    keys.Values = &this->Document.GetNumbers(output,
      path == Rotation    ? TurnsKind
        : path == Weights ? MorphWeightsKind
                          : NumbersKind);
    const std::size_t count = keys.Times->Count;
    const std::size_t wanted =
      count * (keys.Mode == KeyMode::Cubic ? 3 : 1) * (path == Weights ? parts : 1);
    if (keys.Values->Count != wanted)
    {
      output.Fail("has " + std::to_string(keys.Values->Count) + " values, and its input has " +
        std::to_string(count) + " times; expected " + std::to_string(wanted) + " values");
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const double time = keys.Times->Values[i];
      if (!std::isfinite(time) || time < 0. || (i > 0 && time < keys.Times->Values[i - 1]))
      {
        input.Fail("has the time " + std::to_string(time) + " as number " + std::to_string(i) +
          "; expected ascending times of 0 and more");
      }
    }
    const std::vector<double>& times = keys.Times->Values;
    const auto again = std::adjacent_find(times.begin(), times.end());
    if (again != times.end())
    {
      this->Result.Notes.push_back(input.GetPlace() + " has the time " + std::to_string(*again) +
        " more than once; the value changes at once there");
    }
    const std::vector<double>& all = keys.Values->Values;
    if (!std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v); }))
    {
      output.Fail("has a number that is not finite");
    }
    this->Numbers += all.size();
    if (this->Numbers > MostKeyNumbers)
    {
      output.Fail("makes more than " + std::to_string(MostKeyNumbers) +
        " numbers of all keys together; at most these are read");
    }
    return keys;
  }

  //----------------------------------------------------------------------------
  template <typename Convert, typename Value>
  static void Fill(const Keys& keys, Convert&& convert, ModelTrack<Value>& track)
  {
    track = ModelTrack<Value>();
    track.Mode = keys.Mode;
    track.Times = keys.Times->Values;
    for (std::size_t i = 0; i < track.Times.size(); ++i)
    {
      track.Values.push_back(convert(keys.At(i, 1)));
      if (keys.Mode == KeyMode::Cubic)
      {
        track.Before.push_back(convert(keys.At(i, 0)));
        track.After.push_back(convert(keys.At(i, 2)));
      }
    }
  }

  //----------------------------------------------------------------------------
  // All parts of a node share one channel.
  ModelChannel& GetChannel(int node, ModelAnimation& animation)
  {
    const auto [found, isNew] = this->Channels.emplace(node, animation.Channels.size());
    if (isNew)
    {
      animation.Channels.emplace_back();
      animation.Channels.back().Node = node;
    }
    return animation.Channels[found->second];
  }

  GltfDocument& Document;
  const GltfNodes& Nodes;
  Model& Result;
  std::size_t Numbers = 0;             // in all keys
  std::map<int, std::size_t> Channels; // indices in the animation, by node
};
}

//------------------------------------------------------------------------------
void ReadGltfAnimations(GltfDocument& document, const GltfNodes& nodes, Model& model)
{
  AnimationMaker maker(document, nodes, model);
  for (std::size_t i = 0; i < document.Get("animations").GetSize(); ++i)
  {
    maker.Read(i);
  }
}
}
