// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfBuffer.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace scene
{
namespace
{
// Numbers of the glTF 2 specification.
enum Component
{
  UnsignedShort = 5123,
  UnsignedInt = 5125,
  Float = 5126
};
constexpr int VertexTarget = 34962;
constexpr int IndexTarget = 34963;
constexpr std::uint32_t Magic = 0x46546c67; // glTF
constexpr std::uint32_t JsonChunk = 0x4e4f534a;
constexpr std::uint32_t BinaryChunk = 0x004e4942;

void AppendNumber(std::vector<unsigned char>& bytes, std::uint32_t number)
{
  for (int shift = 0; shift < 32; shift += 8)
  {
    bytes.push_back(static_cast<unsigned char>(number >> shift));
  }
}

void AppendChunk(std::vector<unsigned char>& bytes, std::uint32_t type, const void* from,
  std::size_t count, unsigned char filler)
{
  const std::size_t whole = (count + 3) / 4 * 4;
  AppendNumber(bytes, static_cast<std::uint32_t>(whole));
  AppendNumber(bytes, type);
  const auto* first = static_cast<const unsigned char*>(from);
  bytes.insert(bytes.end(), first, first + count);
  bytes.resize(bytes.size() + whole - count, filler);
}
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::Append(const std::string& list, Json&& object)
{
  Json& all = this->Document[list];
  all.push_back(std::move(object));
  return all.size() - 1;
}

//------------------------------------------------------------------------------
void GltfBuffer::Use(const std::string& extension)
{
  Json& used = this->Document["extensionsUsed"];
  if (std::find(used.begin(), used.end(), extension) == used.end())
  {
    used.push_back(extension);
  }
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::AddView(const void* bytes, std::size_t count, int target)
{
  this->Bytes.resize((this->Bytes.size() + 3) / 4 * 4);
  Json view = { { "buffer", 0 }, { "byteOffset", this->Bytes.size() }, { "byteLength", count } };
  if (target != 0)
  {
    view["target"] = target;
  }
  const auto* first = static_cast<const unsigned char*>(bytes);
  this->Bytes.insert(this->Bytes.end(), first, first + count);
  return this->Append("bufferViews", std::move(view));
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::AddFloats(
  const std::vector<float>& values, std::size_t components, bool isVertex, bool withBounds)
{
  static const char* const types[] = { "SCALAR", "VEC2", "VEC3", "VEC4" };
  Json accessor = {
    { "bufferView",
      this->AddView(values.data(), values.size() * sizeof(float), isVertex ? VertexTarget : 0) },
    { "componentType", Float }, { "count", values.size() / components },
    { "type", types[components - 1] }
  };
  if (withBounds)
  {
    std::vector<float> low(values.begin(), values.begin() + static_cast<long>(components));
    std::vector<float> high = low;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      low[i % components] = std::min(low[i % components], values[i]);
      high[i % components] = std::max(high[i % components], values[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  return this->Append("accessors", std::move(accessor));
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::AddIndices(const std::vector<std::uint32_t>& values, std::size_t points)
{
  // The largest index is reserved (primitive restart).
  const bool isShort = points <= std::numeric_limits<std::uint16_t>::max();
  const std::vector<std::uint16_t> shorts(isShort ? values.begin() : values.end(), values.end());
  const std::size_t view = isShort
    ? this->AddView(shorts.data(), shorts.size() * sizeof(shorts[0]), IndexTarget)
    : this->AddView(values.data(), values.size() * sizeof(values[0]), IndexTarget);
  return this->Append("accessors",
    { { "bufferView", view }, { "componentType", isShort ? UnsignedShort : UnsignedInt },
      { "count", values.size() }, { "type", "SCALAR" } });
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::AddColors(const std::vector<std::uint16_t>& values)
{
  const std::size_t view =
    this->AddView(values.data(), values.size() * sizeof(values[0]), VertexTarget);
  return this->Append("accessors",
    { { "bufferView", view }, { "componentType", UnsignedShort }, { "normalized", true },
      { "count", values.size() / 4 }, { "type", "VEC4" } });
}

//------------------------------------------------------------------------------
std::size_t GltfBuffer::AddBytes(const unsigned char* bytes, std::size_t count)
{
  return this->AddView(bytes, count, 0);
}

//------------------------------------------------------------------------------
std::vector<unsigned char> GltfBuffer::GetFile() const
{
  Json document = this->Document;
  if (!this->Bytes.empty())
  {
    document["buffers"] = Json::array({ { { "byteLength", this->Bytes.size() } } });
  }
  // Names that are no UTF-8 become replacement characters.
  const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::size_t size = 28 + (text.size() + 3) / 4 * 4 + (this->Bytes.size() + 3) / 4 * 4;
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    return {};
  }
  std::vector<unsigned char> file;
  file.reserve(size);
  AppendNumber(file, Magic);
  AppendNumber(file, 2);
  AppendNumber(file, 0); // the length, below
  AppendChunk(file, JsonChunk, text.data(), text.size(), ' ');
  if (!this->Bytes.empty())
  {
    AppendChunk(file, BinaryChunk, this->Bytes.data(), this->Bytes.size(), 0);
  }
  std::vector<unsigned char> length;
  AppendNumber(length, static_cast<std::uint32_t>(file.size()));
  std::copy(length.begin(), length.end(), file.begin() + 8);
  return file;
}
}
