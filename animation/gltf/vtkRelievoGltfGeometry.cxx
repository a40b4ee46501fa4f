// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfGeometry.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace relievo
{
namespace
{
using namespace gltf;

enum Mode : std::size_t
{
  Points,
  Lines,
  LineLoop,
  LineStrip,
  Triangles,
  TriangleStrip,
  TriangleFan
};

// Kinds of positions, normals, tangents and coordinates; integers are those of
// KHR_mesh_quantization.
const GltfKind PositionKind = { { "VEC3" }, { Float, Byte, UnsignedByte, Short, UnsignedShort } };
const GltfKind NormalKind = { { "VEC3" }, { Float, Byte, Short }, true };
const GltfKind TangentKind = { { "VEC4" }, { Float, Byte, Short }, true };
const GltfKind TangentChangeKind = { { "VEC3" }, { Float, Byte, Short }, true };
const GltfKind CoordinatesKind = { { "VEC2" },
  { Float, Byte, UnsignedByte, Short, UnsignedShort } };
const GltfKind ColorKind = { { "VEC3", "VEC4" }, { Float, UnsignedByte, UnsignedShort }, true };
const GltfKind JointsKind = { { "VEC4" }, { UnsignedByte, UnsignedShort } };
const GltfKind WeightsKind = { { "VEC4" }, { Float, UnsignedByte, UnsignedShort }, true };
const GltfKind IndicesKind = { { "SCALAR" }, { UnsignedByte, UnsignedShort, UnsignedInt } };

std::size_t GetMode(const GltfValue& primitive)
{
  const GltfValue mode = primitive.Get("mode");
  const std::size_t given = mode.GetCount(Triangles);
  if (given > TriangleFan)
  {
    mode.FailExpecting("0 (points) to 6 (a fan of triangles)");
  }
  return given;
}

// The attributes of a primitive by name, decoded if compressed.
class Attributes
{
public:
  Attributes(GltfDocument& document, const GltfValue& primitive)
    : Document(document)
    , Value(primitive.Get("attributes"))
  {
    if (primitive.Get("extensions").Get("KHR_draco_mesh_compression").IsThere())
    {
      ReadGltfDraco(document, primitive, this->Compressed);
    }
  }

  const GltfPrimitive& GetCompressed() const { return this->Compressed; }

  // Null if missing. Checks that an attribute has as many values as there are points.
  const GltfNumbers* Find(const std::string& name, const GltfKind& kind, std::size_t count)
  {
    const auto decoded = this->Compressed.Attributes.find(name);
    const GltfValue place = this->Value.Get(name.c_str());
    const bool compressed = decoded != this->Compressed.Attributes.end();
    if (compressed)
    {
      this->Document.Check(place, kind);
    }
    const GltfNumbers* numbers = compressed ? &decoded->second
      : place.IsThere()                     ? &this->Document.GetNumbers(place, kind)
                                            : nullptr;
    if (numbers && count > 0 && numbers->Count != count)
    {
      place.Fail("has " + std::to_string(numbers->Count) + " values, but POSITION has " +
        std::to_string(count));
    }
    return numbers;
  }

private:
  GltfDocument& Document;
  GltfValue Value;
  GltfPrimitive Compressed;
};

// The corners in the file's order; each is the index of a point.
std::vector<std::uint32_t> ReadIndices(GltfDocument& document, const GltfValue& primitive,
  const GltfPrimitive& compressed, std::size_t points)
{
  std::vector<std::uint32_t> indices;
  const GltfValue place = primitive.Get("indices");
  if (compressed.IsIndexed)
  {
    indices = compressed.Indices;
  }
  else if (place.IsThere())
  {
    const GltfNumbers& numbers = document.GetNumbers(place, IndicesKind);
    indices.assign(numbers.Values.begin(), numbers.Values.end());
  }
  else
  {
    indices.resize(points);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  const auto strange = std::find_if(
    indices.begin(), indices.end(), [points](std::uint32_t index) { return index >= points; });
  if (strange != indices.end())
  {
    place.Fail("has " + std::to_string(*strange) + " as number " +
      std::to_string(strange - indices.begin()) + ", and POSITION has " + std::to_string(points) +
      " values");
  }
  return indices;
}

// Makes cells by the primitive's mode. Incomplete cells at the end are left out.
void MakeCells(std::size_t mode, const std::vector<std::uint32_t>& indices, GltfGeometry& result)
{
  const std::size_t count = indices.size();
  std::vector<std::uint32_t>& corners = result.Corners;
  const auto add = [&](std::initializer_list<std::size_t> places) {
    for (const std::size_t place : places)
    {
      corners.push_back(indices[place]);
    }
  };
  result.CellSize = mode == Points ? 1 : mode <= LineStrip ? 2 : 3;
  switch (mode)
  {
    case Points:
    case Lines:
    case Triangles:
    {
      const auto whole = count - count % static_cast<std::size_t>(result.CellSize);
      corners.assign(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(whole));
      break;
    }
    case LineLoop:
    case LineStrip:
      for (std::size_t i = 0; i + 1 < count; ++i)
      {
        add({ i, i + 1 });
      }
      if (mode == LineLoop && count > 1)
      {
        add({ count - 1, 0 });
      }
      break;
    case TriangleStrip:
      for (std::size_t i = 0; i + 2 < count; ++i)
      {
        add({ i, i + 1 + i % 2, i + 2 - i % 2 });
      }
      break;
    default:
      for (std::size_t i = 0; i + 2 < count; ++i)
      {
        add({ i + 1, i + 2, 0 });
      }
  }
}

// The points that corners use: each once and in order or, if triangles share none, one for each
// corner. Renumbers the corners.
std::vector<std::uint32_t> ChoosePoints(
  std::size_t count, bool shared, std::vector<std::uint32_t>& corners)
{
  if (!shared)
  {
    std::vector<std::uint32_t> taken = corners;
    std::iota(corners.begin(), corners.end(), 0u);
    return taken;
  }
  std::vector<std::uint32_t> taken = corners;
  std::sort(taken.begin(), taken.end());
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
  if (taken.size() == count)
  {
    return taken;
  }
  for (std::uint32_t& corner : corners)
  {
    corner = static_cast<std::uint32_t>(
      std::lower_bound(taken.begin(), taken.end(), corner) - taken.begin());
  }
  return taken;
}

template <typename Value>
std::vector<Value> Take(const GltfNumbers* numbers, const std::vector<std::uint32_t>& taken)
{
  std::vector<Value> values;
  if (numbers)
  {
    values.reserve(taken.size());
    for (const std::uint32_t point : taken)
    {
      const double* from = numbers->At(point);
      Value value;
      for (int i = 0; i < static_cast<int>(sizeof(Value) / sizeof(double)); ++i)
      {
        value[i] = from[i];
      }
      values.push_back(value);
    }
  }
  return values;
}

bool IsFinite(const double* from)
{
  return std::isfinite(from[0]) && std::isfinite(from[1]) && std::isfinite(from[2]);
}

// Removes cells with non-finite points. Returns the number of such points.
std::size_t LeaveOutInfinite(const GltfNumbers& positions, GltfGeometry& result)
{
  std::vector<std::uint32_t> kept;
  std::set<std::uint32_t> unfit;
  const auto size = static_cast<std::size_t>(result.CellSize);
  for (std::size_t i = 0; i + size <= result.Corners.size(); i += size)
  {
    bool fits = true;
    for (std::size_t j = i; j < i + size; ++j)
    {
      if (!IsFinite(positions.At(result.Corners[j])))
      {
        unfit.insert(result.Corners[j]);
        fits = false;
      }
    }
    if (fits)
    {
      const auto begin = result.Corners.begin() + static_cast<std::ptrdiff_t>(i);
      kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
    }
  }
  if (!unfit.empty())
  {
    result.Corners = std::move(kept);
  }
  return unfit.size();
}

void ReadCoordinates(Attributes& attributes, const ModelMaterial& material,
  const std::vector<std::uint32_t>& taken, std::size_t count, GltfGeometry& result)
{
  const ModelTexture* const textures[] = { &material.BaseColorTexture, &material.MetalTexture,
    &material.NormalTexture, &material.OcclusionTexture, &material.EmissionTexture };
  const auto* const found = std::find_if(std::begin(textures), std::end(textures),
    [](const ModelTexture* texture) { return !texture->Image.empty(); });
  const ModelTexture none;
  const ModelTexture& texture = found == std::end(textures) ? none : **found;
  const GltfNumbers* coordinates =
    attributes.Find("TEXCOORD_" + std::to_string(texture.Coordinates), CoordinatesKind, count);
  result.Coordinates = Take<glm::dvec2>(coordinates, taken);
  for (glm::dvec2& place : result.Coordinates)
  {
    const glm::dvec3 moved = texture.Transform * glm::dvec3(place, 1.);
    place = { moved.x, 1. - moved.y };
  }
}

void ReadColors(Attributes& attributes, const std::vector<std::uint32_t>& taken, std::size_t count,
  GltfGeometry& result)
{
  const GltfNumbers* colors = attributes.Find("COLOR_0", ColorKind, count);
  if (!colors)
  {
    return;
  }
  result.Colors.reserve(taken.size());
  for (const std::uint32_t point : taken)
  {
    const double* from = colors->At(point);
    const double alpha = colors->Components == 4 ? from[3] : 1.;
    glm::dvec4 color(from[0], from[1], from[2], alpha);
    for (int i = 0; i < 4; ++i)
    {
      color[i] = color[i] > 0. ? std::min(color[i], 1.) : 0.; // also makes NaN 0
    }
    result.Colors.push_back(color);
  }
}

// Joints and weights come in sets of four. Joints of weight 0 may have any value.
void ReadInfluences(Attributes& attributes, const std::vector<std::uint32_t>& taken,
  std::size_t count, GltfGeometry& result)
{
  for (int set = 0;; ++set)
  {
    const std::string number = std::to_string(set);
    const GltfNumbers* joints = attributes.Find("JOINTS_" + number, JointsKind, count);
    const GltfNumbers* weights = attributes.Find("WEIGHTS_" + number, WeightsKind, count);
    if (!joints || !weights)
    {
      return;
    }
    result.Influences.resize(taken.size());
    for (std::size_t i = 0; i < taken.size(); ++i)
    {
      std::vector<ModelInfluence>& own = result.Influences[i];
      for (std::size_t j = 0; j < 4; ++j)
      {
        const double weight = weights->At(taken[i])[j];
        const int joint = static_cast<int>(joints->At(taken[i])[j]);
        if (!std::isfinite(weight) || weight < 0.)
        {
          ++result.Faults.Unfit;
        }
        else if (weight > 0.)
        {
          const auto same = std::find_if(own.begin(), own.end(),
            [joint](const ModelInfluence& other) { return other.Bone == joint; });
          if (same != own.end())
          {
            same->Weight += weight; // the joint is listed twice
          }
          else
          {
            own.push_back({ joint, weight });
          }
        }
      }
    }
  }
}

void ReadTargets(GltfDocument& document, const GltfValue& primitive,
  const std::vector<std::uint32_t>& taken, std::size_t count, GltfGeometry& result)
{
  const GltfValue targets = primitive.Get("targets");
  for (std::size_t i = 0; i < targets.GetSize(); ++i)
  {
    const auto read = [&](const char* name, const GltfKind& kind) {
      const GltfValue place = targets.At(i).Get(name);
      const GltfNumbers* numbers = place.IsThere() ? &document.GetNumbers(place, kind) : nullptr;
      if (numbers && numbers->Count != count)
      {
        place.Fail("has " + std::to_string(numbers->Count) + " values, but POSITION has " +
          std::to_string(count));
      }
      return Take<glm::dvec3>(numbers, taken);
    };
    GltfTarget target;
    target.Points = read("POSITION", PositionKind);
    target.Normals =
      result.Normals.empty() ? std::vector<glm::dvec3>() : read("NORMAL", NormalKind);
    target.Tangents =
      result.Tangents.empty() ? std::vector<glm::dvec3>() : read("TANGENT", TangentChangeKind);
    result.Targets.push_back(std::move(target));
  }
}
}

//------------------------------------------------------------------------------
void CountGltfGeometry(const GltfDocument& document, const GltfValue& primitive,
  std::size_t& points, std::size_t& corners)
{
  const std::size_t mode = GetMode(primitive);
  const GltfValue attributes = primitive.Get("attributes");
  const std::size_t all = document.GetCount(attributes.Get("POSITION"));
  const std::size_t indices =
    primitive.Get("indices").IsThere() ? document.GetCount(primitive.Get("indices")) : all;
  corners = mode == Points || mode == Lines || mode == Triangles ? indices
    : mode <= LineStrip                                          ? 2 * indices
                                                                 : 3 * indices;
  points =
    attributes.Get("NORMAL").IsThere() || mode < Triangles ? std::min(all, corners) : corners;
  points *= 1 + primitive.Get("targets").GetSize();
}

//------------------------------------------------------------------------------
GltfGeometry ReadGltfGeometry(GltfDocument& document, const GltfValue& primitive, Model& model)
{
  GltfGeometry result;
  const int material =
    primitive.Get("material").GetIndex("materials", document.Get("materials").GetSize());
  // The last material is that of meshes without one.
  result.Material = material < 0 ? model.Materials.size() - 1 : static_cast<std::size_t>(material);
  Attributes attributes(document, primitive);
  const GltfNumbers* positions = attributes.Find("POSITION", PositionKind, 0);
  if (!positions)
  {
    model.Notes.push_back(primitive.GetPlace() + " has no POSITION, and is left out");
    return result;
  }
  const std::size_t count = positions->Count;
  const std::size_t mode = GetMode(primitive);
  const std::vector<std::uint32_t> indices =
    ReadIndices(document, primitive, attributes.GetCompressed(), count);
  MakeCells(mode, indices, result);
  const std::size_t unfit = LeaveOutInfinite(*positions, result);
  if (unfit > 0)
  {
    model.Notes.push_back(primitive.GetPlace() + ": " + std::to_string(unfit) +
      " points are not finite; they are left out, and the cells that have them");
  }
  if ((mode == Triangles || mode == Lines) &&
    indices.size() % static_cast<std::size_t>(result.CellSize) != 0)
  {
    model.Notes.push_back(primitive.GetPlace() + " has " + std::to_string(indices.size()) +
      " corners, which is no multiple of " + std::to_string(result.CellSize) +
      "; those left over are left out");
  }
  const GltfNumbers* normals = attributes.Find("NORMAL", NormalKind, count);
  const bool shared = normals || result.CellSize < 3;
  const std::vector<std::uint32_t> taken = ChoosePoints(count, shared, result.Corners);
  result.Points = Take<glm::dvec3>(positions, taken);
  result.Normals = Take<glm::dvec3>(normals, taken);
  if (normals) // tangents are useless without normals
  {
    result.Tangents = Take<glm::dvec4>(attributes.Find("TANGENT", TangentKind, count), taken);
  }
  ReadCoordinates(attributes, model.Materials[result.Material], taken, count, result);
  ReadColors(attributes, taken, count, result);
  ReadInfluences(attributes, taken, count, result);
  ReadTargets(document, primitive, taken, count, result);
  return result;
}
}
