// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfDocument.h"

#include <algorithm>
#include <cstring>

namespace relievo
{
namespace
{
std::size_t GetComponents(std::size_t type)
{
  constexpr std::size_t components[] = { 1, 2, 3, 4, 4, 9, 16 };
  return components[type];
}

const std::vector<std::string> Types = { "SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4" };

std::string NameComponentType(int type)
{
  switch (type)
  {
    case gltf::Byte:
      return "BYTE";
    case gltf::UnsignedByte:
      return "UNSIGNED_BYTE";
    case gltf::Short:
      return "SHORT";
    case gltf::UnsignedShort:
      return "UNSIGNED_SHORT";
    case gltf::UnsignedInt:
      return "UNSIGNED_INT";
    default:
      return "FLOAT";
  }
}

std::size_t GetBytes(int componentType)
{
  return componentType <= gltf::UnsignedByte ? 1 : componentType <= gltf::UnsignedShort ? 2 : 4;
}

double ReadComponent(const unsigned char* at, int type)
{
  switch (type)
  {
    case gltf::Byte:
      return static_cast<signed char>(*at);
    case gltf::UnsignedByte:
      return *at;
    case gltf::Short:
      return static_cast<std::int16_t>(ReadLittle(at, 2));
    case gltf::UnsignedShort:
      return static_cast<double>(ReadLittle(at, 2));
    case gltf::UnsignedInt:
      return static_cast<double>(ReadLittle(at, 4));
    default:
    {
      const auto bits = static_cast<std::uint32_t>(ReadLittle(at, 4));
      float number;
      std::memcpy(&number, &bits, 4);
      return number;
    }
  }
}

double GetNormalized(double number, int type)
{
  switch (type)
  {
    case gltf::Byte:
      return std::max(number / 127., -1.);
    case gltf::UnsignedByte:
      return number / 255.;
    case gltf::Short:
      return std::max(number / 32767., -1.);
    case gltf::UnsignedShort:
      return number / 65535.;
    default:
      return number;
  }
}

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}
}

// The memory layout of an accessor's values.
struct GltfDocument::Layout
{
  std::string Type;
  int ComponentType = gltf::Float;
  std::size_t Components = 1;
  std::size_t Count = 0;
  bool Normalized = false;

  std::size_t GetSize() const { return this->Components * GetBytes(this->ComponentType); }

  void Read(const unsigned char* from, bool normalized, double* to) const
  {
    for (std::size_t i = 0; i < this->Components; ++i)
    {
      const double number =
        ReadComponent(from + i * GetBytes(this->ComponentType), this->ComponentType);
      to[i] = normalized ? GetNormalized(number, this->ComponentType) : number;
    }
  }
};

//------------------------------------------------------------------------------
GltfDocument::Layout GltfDocument::GetLayout(const GltfValue& accessor) const
{
  Layout layout;
  if (!accessor.Get("type").IsThere() || !accessor.Get("count").IsThere() ||
    !accessor.Get("componentType").IsThere())
  {
    accessor.Fail("lacks its type, componentType or count");
  }
  const std::size_t type = accessor.Get("type").GetWord(Types);
  layout.Type = Types[type];
  layout.Components = GetComponents(type);
  layout.Count = accessor.Get("count").GetCount(0, 1);
  const std::size_t componentType = accessor.Get("componentType").GetCount(0);
  const bool known =
    componentType >= gltf::Byte && componentType <= gltf::Float && componentType != 5124;
  if (!known)
  {
    accessor.Get("componentType").FailExpecting("5120, 5121, 5122, 5123, 5125 or 5126");
  }
  layout.ComponentType = static_cast<int>(componentType);
  layout.Normalized = accessor.Get("normalized").GetFlag(false);
  return layout;
}

//------------------------------------------------------------------------------
const unsigned char* GltfDocument::Find(const GltfValue& owner, const std::string& what,
  std::size_t count, std::size_t bytes, std::size_t alignment, std::size_t& stride)
{
  const GltfValue views = this->Get("bufferViews");
  const int view = owner.Get("bufferView").GetIndex("bufferViews", views.GetSize());
  if (view < 0)
  {
    owner.Get("bufferView").FailExpecting("a number");
  }
  const GltfValue value = views.At(static_cast<std::size_t>(view));
  const GltfBytes whole = this->GetView(static_cast<std::size_t>(view));
  const std::size_t given = value.Get("byteStride").GetCount(bytes);
  stride = given;
  if (given < bytes || given % alignment != 0)
  {
    value.Get("byteStride")
      .Fail("is " + std::to_string(given) + ", and " + owner.GetPlace() + " has values of " +
        std::to_string(bytes) + " bytes; expected at least these, and a multiple of " +
        std::to_string(alignment));
  }
  const std::size_t offset = owner.Get("byteOffset").GetCount(0);
  if (offset > whole.Size || bytes > whole.Size - offset ||
    count - 1 > (whole.Size - offset - bytes) / given)
  {
    owner.Fail("has " + std::to_string(count) + " " + what + " of " + std::to_string(bytes) +
      " bytes from byte " + std::to_string(offset) +
      (given == bytes ? "" : ", each " + std::to_string(given) + " bytes on") + ", but " +
      value.GetPlace() + " has " + std::to_string(whole.Size) + " bytes");
  }
  if ((offset + value.Get("byteOffset").GetCount(0)) % alignment != 0)
  {
    owner.Fail("begins at byte " + std::to_string(offset) + " of " + value.GetPlace() +
      ", which begins at byte " + std::to_string(value.Get("byteOffset").GetCount(0)) +
      " of its buffer; expected a multiple of " + std::to_string(alignment) + " together");
  }
  return whole.Data + offset;
}

//------------------------------------------------------------------------------
void GltfDocument::ReadDense(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers)
{
  if (!accessor.Get("bufferView").IsThere())
  {
    if (layout.Count > gltf::MostZeros)
    {
      accessor.Fail("has " + std::to_string(layout.Count) +
        " values without a bufferView; at most " + std::to_string(gltf::MostZeros) + " are read");
    }
    numbers.Values.assign(layout.Count * layout.Components, 0.);
    return;
  }
  std::size_t stride = 0;
  const unsigned char* from = this->Find(
    accessor, "values", layout.Count, layout.GetSize(), GetBytes(layout.ComponentType), stride);
  numbers.Values.resize(layout.Count * layout.Components);
  for (std::size_t i = 0; i < layout.Count; ++i)
  {
    layout.Read(
      from + i * stride, layout.Normalized, numbers.Values.data() + i * layout.Components);
  }
}

//------------------------------------------------------------------------------
void GltfDocument::ReadSparse(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers)
{
  const GltfValue sparse = accessor.Get("sparse");
  const std::size_t count = sparse.Get("count").GetCount(0, 1);
  if (!sparse.Get("count").IsThere() || count > layout.Count)
  {
    sparse.Get("count").FailExpecting("1 to " + std::to_string(layout.Count));
  }
  const GltfValue indices = sparse.Get("indices");
  const GltfValue values = sparse.Get("values");
  const auto type = static_cast<int>(indices.Get("componentType").GetCount(0));
  if (type != gltf::UnsignedByte && type != gltf::UnsignedShort && type != gltf::UnsignedInt)
  {
    indices.Get("componentType").FailExpecting("5121, 5123 or 5125");
  }
  std::size_t stride = 0;
  std::size_t valueStride = 0;
  const unsigned char* places =
    this->Find(indices, "values", count, GetBytes(type), GetBytes(type), stride);
  const unsigned char* from = this->Find(
    values, "values", count, layout.GetSize(), GetBytes(layout.ComponentType), valueStride);
  std::size_t before = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto place = static_cast<std::size_t>(ReadComponent(places + i * stride, type));
    if (place >= layout.Count || (i > 0 && place <= before))
    {
      indices.Fail("has " + std::to_string(place) + " as number " + std::to_string(i) +
        (i > 0 ? ", after " + std::to_string(before) : "") + "; expected ascending numbers below " +
        std::to_string(layout.Count));
    }
    before = place;
    layout.Read(
      from + i * valueStride, layout.Normalized, numbers.Values.data() + place * layout.Components);
  }
}

//------------------------------------------------------------------------------
std::size_t GltfDocument::GetCount(const GltfValue& place) const
{
  return place.IsThere() ? this->GetLayout(this->GetAccessor(place)).Count : 0;
}

//------------------------------------------------------------------------------
GltfValue GltfDocument::GetAccessor(const GltfValue& place) const
{
  const GltfValue accessors = this->Get("accessors");
  const int index = place.GetIndex("accessors", accessors.GetSize());
  if (index < 0)
  {
    place.FailExpecting("the number of an accessor");
  }
  return accessors.At(static_cast<std::size_t>(index));
}

//------------------------------------------------------------------------------
void GltfDocument::CheckDecoded(const GltfValue& place, GltfNumbers& numbers) const
{
  const GltfValue accessor = this->GetAccessor(place);
  const Layout layout = this->GetLayout(accessor);
  if (layout.Count != numbers.Count || layout.Components != numbers.Components)
  {
    accessor.Fail("has " + std::to_string(layout.Count) + " values of " +
      std::to_string(layout.Components) + " numbers, and its compressed data have " +
      std::to_string(numbers.Count) + " of " + std::to_string(numbers.Components));
  }
  if (layout.Normalized)
  {
    for (double& number : numbers.Values)
    {
      number = GetNormalized(number, layout.ComponentType);
    }
  }
}

//------------------------------------------------------------------------------
bool GltfDocument::Check(const GltfValue& place, const GltfKind& kind) const
{
  const GltfValue accessor = this->GetAccessor(place);
  const Layout layout = this->GetLayout(accessor);
  const auto has = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  if (!has(kind.Types, layout.Type) || !has(kind.ComponentTypes, layout.ComponentType))
  {
    std::vector<std::string> names;
    for (const int type : kind.ComponentTypes)
    {
      names.push_back(NameComponentType(type));
    }
    place.Fail("names " + accessor.GetPlace() + ", which is " + layout.Type + " of " +
      NameComponentType(layout.ComponentType) + ", expected " + Join(kind.Types) + " of " +
      Join(names));
  }
  return layout.Normalized || kind.Normalized;
}

//------------------------------------------------------------------------------
const GltfNumbers& GltfDocument::GetNumbers(const GltfValue& place, const GltfKind& kind)
{
  const bool normalized = this->Check(place, kind);
  const GltfValue accessor = this->GetAccessor(place);
  const auto [found, isNew] = this->Numbers.try_emplace({ accessor.GetPlace(), normalized });
  GltfNumbers& numbers = found->second;
  if (isNew)
  {
    Layout layout = this->GetLayout(accessor);
    layout.Normalized = normalized;
    numbers.Count = layout.Count;
    numbers.Components = layout.Components;
    this->ReadDense(accessor, layout, numbers);
    if (accessor.Get("sparse").IsThere())
    {
      this->ReadSparse(accessor, layout, numbers);
    }
  }
  return numbers;
}
}
