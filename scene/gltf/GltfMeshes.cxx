// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMeshes.h"

#include "GltfSurface.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace scene
{
namespace
{
using Json = GltfBuffer::Json;

void AddVector(std::vector<float>& values, const glm::dvec3& vector)
{
  for (int i = 0; i < 3; ++i)
  {
    values.push_back(static_cast<float>(vector[i]));
  }
}

Json WritePrimitive(const GltfPrimitive& primitive, const glm::dvec3& origin, GltfBuffer& buffer)
{
  std::vector<float> positions;
  positions.reserve(3 * primitive.Positions.size());
  for (const glm::dvec3& point : primitive.Positions)
  {
    AddVector(positions, point - origin);
  }
  Json attributes = { { "POSITION", buffer.AddFloats(positions, 3, true, true) } };
  if (!primitive.Normals.empty())
  {
    attributes["NORMAL"] = buffer.AddFloats(primitive.Normals, 3, true);
  }
  if (!primitive.Coordinates.empty())
  {
    attributes["TEXCOORD_0"] = buffer.AddFloats(primitive.Coordinates, 2, true);
  }
  if (!primitive.Colors.empty())
  {
    attributes["COLOR_0"] = buffer.AddColors(primitive.Colors);
  }
  return { { "attributes", attributes },
    { "indices", buffer.AddIndices(primitive.Indices, primitive.Positions.size()) },
    { "mode", static_cast<int>(primitive.Mode) } };
}

// Whether vertices of the keys differ from the shape's in their places alone.
bool HasVerticesOf(const GltfShape& shape, const GltfShape& key)
{
  return std::equal(shape.Primitives.begin(), shape.Primitives.end(), key.Primitives.begin(),
    key.Primitives.end(), [](const GltfPrimitive& a, const GltfPrimitive& b) {
      return a.Mode == b.Mode && a.Indices == b.Indices &&
        a.Positions.size() == b.Positions.size() && a.Normals.size() == b.Normals.size();
    });
}

bool IsStill(const GltfShape& shape, const std::vector<const GltfShape*>& keys)
{
  return std::all_of(keys.begin(), keys.end(), [&shape](const GltfShape* key) {
    return std::equal(shape.Primitives.begin(), shape.Primitives.end(), key->Primitives.begin(),
      key->Primitives.end(), [](const GltfPrimitive& a, const GltfPrimitive& b) {
        return a.Positions == b.Positions && a.Normals == b.Normals;
      });
  });
}
}

//------------------------------------------------------------------------------
GltfMeshes::GltfMeshes(GltfBuffer& buffer, GltfMaterials& materials, std::set<std::string>& notes,
  const std::vector<double>& times)
  : Buffer(buffer)
  , Materials(materials)
  , Notes(notes)
  , Times(times)
{
}

//------------------------------------------------------------------------------
std::size_t GltfMeshes::GetTimes()
{
  if (!this->TimesAccessor)
  {
    // glTF's times begin at 0 or later.
    const double first = this->Times.front();
    std::vector<float> times;
    for (const double time : this->Times)
    {
      times.push_back(static_cast<float>(first < 0. ? time - first : time));
    }
    this->TimesAccessor = this->Buffer.AddFloats(times, 1, false, true);
  }
  return *this->TimesAccessor;
}

//------------------------------------------------------------------------------
void GltfMeshes::AddChannel(
  std::size_t node, const char* path, const std::vector<float>& values, std::size_t components)
{
  this->Channels.push_back(
    { { "sampler", this->Samplers.size() }, { "target", { { "node", node }, { "path", path } } } });
  const std::size_t input = this->GetTimes();
  this->Samplers.push_back(
    { { "input", input }, { "output", this->Buffer.AddFloats(values, components, false) },
      { "interpolation", "LINEAR" } });
}

//------------------------------------------------------------------------------
void GltfMeshes::Move(std::size_t node, const std::vector<GltfPlace>& places)
{
  const auto differ = [&places](const auto& part) {
    return std::any_of(places.begin(), places.end(),
      [&](const GltfPlace& place) { return part(place) != part(places.front()); });
  };
  const auto translation = [](const GltfPlace& place) { return place.Translation; };
  const auto scale = [](const GltfPlace& place) { return place.Scale; };
  if (differ(translation))
  {
    std::vector<float> values;
    for (const GltfPlace& place : places)
    {
      AddVector(values, place.Translation);
    }
    this->AddChannel(node, "translation", values, 3);
  }
  if (differ([](const GltfPlace& place) { return place.Rotation; }))
  {
    std::vector<float> values;
    glm::dvec4 before = places.front().Rotation;
    for (const GltfPlace& place : places)
    {
      // Of the two quaternions of a rotation, the one closer to the key before.
      before = glm::dot(before, place.Rotation) < 0. ? -place.Rotation : place.Rotation;
      for (int i = 0; i < 4; ++i)
      {
        values.push_back(static_cast<float>(before[i]));
      }
    }
    this->AddChannel(node, "rotation", values, 4);
  }
  if (differ(scale))
  {
    std::vector<float> values;
    for (const GltfPlace& place : places)
    {
      AddVector(values, place.Scale);
    }
    this->AddChannel(node, "scale", values, 3);
  }
}

//------------------------------------------------------------------------------
// A target for each key, whose weight is 1 at its time, and 0 at the other keys.
void GltfMeshes::AddMorphs(
  Json& mesh, const GltfShape& shape, const std::vector<const GltfShape*>& keys)
{
  for (std::size_t i = 0; i < shape.Primitives.size(); ++i)
  {
    const GltfPrimitive& rest = shape.Primitives[i];
    Json targets = Json::array();
    for (const GltfShape* key : keys)
    {
      const GltfPrimitive& moved = key->Primitives[i];
      std::vector<float> positions;
      for (std::size_t j = 0; j < rest.Positions.size(); ++j)
      {
        AddVector(positions, moved.Positions[j] - rest.Positions[j]);
      }
      Json target = { { "POSITION", this->Buffer.AddFloats(positions, 3, true, true) } };
      if (!rest.Normals.empty())
      {
        std::vector<float> normals(rest.Normals.size());
        std::transform(moved.Normals.begin(), moved.Normals.end(), rest.Normals.begin(),
          normals.begin(), [](float a, float b) { return a - b; });
        target["NORMAL"] = this->Buffer.AddFloats(normals, 3, true);
      }
      targets.push_back(std::move(target));
    }
    mesh["primitives"][i]["targets"] = std::move(targets);
  }
  mesh["weights"] = std::vector<double>(keys.size(), 0.);
}

//------------------------------------------------------------------------------
std::optional<std::size_t> GltfMeshes::Add(const GltfSurface& surface, const GltfShape& shape,
  const std::string& name, const std::vector<const GltfShape*>& keys)
{
  if (surface.Actor->GetProperty()->GetEdgeVisibility())
  {
    this->Notes.insert("edges are left out: glTF has none on surfaces");
  }
  if (shape.Primitives.empty())
  {
    return std::nullopt;
  }
  vtkProperty* property = surface.Actor->GetProperty();
  for (const GltfPrimitive& primitive : shape.Primitives)
  {
    const double size = primitive.Mode == GltfPrimitive::Points ? property->GetPointSize()
      : primitive.Mode == GltfPrimitive::Lines                  ? property->GetLineWidth()
                                                                : 1.;
    if (size != 1.)
    {
      this->Notes.insert("sizes of points and widths of lines are left out: glTF has none");
    }
  }
  const glm::dvec3 origin = shape.ChooseOrigin();
  Json primitives = Json::array();
  for (const GltfPrimitive& primitive : shape.Primitives)
  {
    Json written = WritePrimitive(primitive, origin, this->Buffer);
    written["material"] = this->Materials.Find(
      surface, !primitive.Coordinates.empty(), primitive.Mode == GltfPrimitive::Triangles);
    primitives.push_back(std::move(written));
  }
  Json mesh = { { "primitives", primitives } };
  if (!name.empty())
  {
    mesh["name"] = name;
  }
  const bool isFollowed = std::all_of(keys.begin(), keys.end(), [&shape](const GltfShape* key) {
    return key && key->IsPlaced == shape.IsPlaced && HasVerticesOf(shape, *key);
  });
  if (!isFollowed)
  {
    this->Notes.insert((name.empty() ? "a mesh" : name) +
      " rests: it is not the same mesh, with other points, at each time");
  }
  const bool isMorphed = isFollowed && !IsStill(shape, keys);
  if (isMorphed)
  {
    this->AddMorphs(mesh, shape, keys);
  }
  const auto placed = [&origin](const GltfShape& of) {
    GltfPlace place = of.Place;
    place.Translation += place.Turn(origin);
    return place;
  };
  Json node = placed(shape).GetNode(name);
  node["mesh"] = this->Buffer.Append("meshes", std::move(mesh));
  const std::size_t made = this->Buffer.Append("nodes", std::move(node));
  if (isFollowed && !keys.empty())
  {
    std::vector<GltfPlace> places;
    for (const GltfShape* key : keys)
    {
      places.push_back(placed(*key));
    }
    this->Move(made, places);
  }
  if (isMorphed)
  {
    std::vector<float> weights;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      for (std::size_t j = 0; j < keys.size(); ++j)
      {
        weights.push_back(i == j ? 1.F : 0.F);
      }
    }
    this->AddChannel(made, "weights", weights, 1);
  }
  return made;
}

//------------------------------------------------------------------------------
void GltfMeshes::Finish()
{
  if (!this->Channels.empty())
  {
    this->Buffer.Append(
      "animations", { { "channels", this->Channels }, { "samplers", this->Samplers } });
  }
}
}
