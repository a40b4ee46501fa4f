// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfContainer.h"

#include "vtkRelievoFileKind.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace relievo
{
namespace
{
// Supported extensions; unsupported ones of materials are noted because they change the appearance.
const std::set<std::string> KnownExtensions = { "KHR_draco_mesh_compression", "KHR_lights_punctual",
  "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization",
  "KHR_texture_transform" };

// The value of a base64 character, or -1.
int FindDigit(char c)
{
  return c >= 'A' && c <= 'Z' ? c - 'A'
    : c >= 'a' && c <= 'z'    ? c - 'a' + 26
    : c >= '0' && c <= '9'    ? c - '0' + 52
    : c == '+' || c == '-'    ? 62
    : c == '/' || c == '_'    ? 63
                              : -1;
}

int FindHexDigit(char c)
{
  return c >= '0' && c <= '9' ? c - '0'
    : c >= 'a' && c <= 'f'    ? c - 'a' + 10
    : c >= 'A' && c <= 'F'    ? c - 'A' + 10
                              : -1;
}

// Escapes such as %20 become single characters.
std::string DecodeUri(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && FindHexDigit(uri[i + 1]) >= 0 &&
      FindHexDigit(uri[i + 2]) >= 0;
    text +=
      coded ? static_cast<char>(16 * FindHexDigit(uri[i + 1]) + FindHexDigit(uri[i + 2])) : uri[i];
    i += coded ? 2 : 0;
  }
  return text;
}

// A scheme such as http: ends before the first slash.
bool HasScheme(const std::string& uri)
{
  const std::size_t colon = uri.find(':');
  return colon != std::string::npos && colon > 1 && colon < uri.find('/');
}

// Throws why the file cannot be read. Opens only regular files: others may never end.
std::vector<unsigned char> ReadBytes(const std::string& path, std::uintmax_t& read)
{
  std::error_code unknown;
  const std::string instead = vtkRelievoFileKind::FindInstead(path);
  if (!instead.empty())
  {
    throw GltfError(instead.substr(3) + ", expected a file"); // removes "it "
  }
  if (!std::filesystem::exists(path, unknown))
  {
    throw GltfError("is not there");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (unknown || size > gltf::MostBytes - std::min(read, gltf::MostBytes))
  {
    throw GltfError("makes more than " + std::to_string(gltf::MostBytes >> 30) +
      " GB with the files that were read before it; at most these are read");
  }
  read += size;
  std::ifstream file(path, std::ios::binary);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file)
  {
    throw GltfError("cannot be read");
  }
  return bytes;
}

// Decodes base64; false if the text contains anything else.
bool DecodeBase64(const char* text, std::size_t size, std::vector<unsigned char>& bytes)
{
  while (size > 0 && text[size - 1] == '=' && size % 4 != 1)
  {
    --size;
  }
  bytes.clear();
  bytes.reserve(size / 4 * 3 + 3);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const int digit = FindDigit(text[i]);
    if (digit < 0)
    {
      return false;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    if (i % 4 != 0)
    {
      bytes.push_back(static_cast<unsigned char>(bits >> (6 - 2 * (i % 4))));
    }
  }
  return size % 4 != 1;
}
}

//------------------------------------------------------------------------------
std::size_t ReadLittle(const unsigned char* at, int bytes)
{
  std::size_t number = 0;
  for (int i = bytes; i-- > 0;)
  {
    number = number << 8 | at[i];
  }
  return number;
}

//------------------------------------------------------------------------------
GltfContainer::GltfContainer(
  const std::string& path, const vtkRelievoAllowedFolders& allowed, ModelSources& sources)
  : Path(path)
  , Allowed(allowed)
  , Sources(sources)
{
  this->Open();
  this->CheckExtensions();
}

//------------------------------------------------------------------------------
void GltfContainer::Open()
{
  std::vector<unsigned char> bytes;
  try
  {
    bytes = ReadBytes(this->Path, this->Read);
  }
  catch (const GltfError& error)
  {
    throw GltfError(std::string("it ") + error.what());
  }
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "glTF", 4) != 0)
  {
    this->Parse(bytes.data(), bytes.size());
    return;
  }
  const auto number = [&](std::size_t at) { return ReadLittle(bytes.data() + at, 4); };
  if (bytes.size() < 20)
  {
    throw GltfError("it has " + std::to_string(bytes.size()) +
      " bytes, expected a head and a chunk of JSON; it is cut short");
  }
  if (number(4) != 2)
  {
    throw GltfError("it is binary glTF " + std::to_string(number(4)) + ", expected 2");
  }
  if (number(8) > bytes.size())
  {
    throw GltfError("its head says " + std::to_string(number(8)) + " bytes, and it has " +
      std::to_string(bytes.size()) + "; it is cut short");
  }
  const std::size_t end = number(8);
  constexpr std::size_t json = 0x4E4F534A;
  constexpr std::size_t binary = 0x004E4942;
  std::size_t at = 12;
  for (int chunk = 0; at + 8 <= end; ++chunk)
  {
    const std::size_t size = number(at);
    const std::size_t kind = number(at + 4);
    at += 8;
    if (size > end - at)
    {
      throw GltfError("its chunk " + std::to_string(chunk) + " says " + std::to_string(size) +
        " bytes, and " + std::to_string(end - at) + " are left");
    }
    if (chunk == 0)
    {
      if (kind != json)
      {
        throw GltfError("its first chunk is not JSON");
      }
      this->Parse(bytes.data() + at, size);
    }
    else if (kind == binary && this->Chunk.empty())
    {
      const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      this->Chunk.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
    }
    at += size;
  }
  if (this->Json.is_null())
  {
    throw GltfError("it has no chunk of JSON");
  }
}

//------------------------------------------------------------------------------
void GltfContainer::Parse(const unsigned char* text, std::size_t size)
{
  if (size >= 2 && (text[0] == 0 || text[1] == 0 || text[0] >= 0xFE))
  {
    throw GltfError("it is text in UTF-16 or not text, expected JSON in UTF-8");
  }
  // Parsers may overflow the stack if values are nested too deeply.
  const auto check = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > gltf::DeepestValues)
    {
      throw GltfError("its JSON is nested more than " + std::to_string(gltf::DeepestValues) +
        " deep; at most this is read");
    }
    return true;
  };
  try
  {
    this->Json = nlohmann::json::parse(text, text + size, check);
  }
  catch (const nlohmann::json::exception& error)
  {
    std::string what = error.what();
    const std::size_t begin = what.find("] ");
    // The message quotes bytes of the file, which may not be text.
    std::replace_if(
      what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) > 126; }, '?');
    throw GltfError(
      "it is not JSON: " + (begin == std::string::npos ? what : what.substr(begin + 2)));
  }
  const GltfValue asset = this->Get("asset");
  const GltfValue version = asset.Get("version");
  const std::string given = version.GetText("");
  if (!version.IsThere() || given.substr(0, 2) != "2.")
  {
    version.FailExpecting("\"2.0\"");
  }
  const GltfValue least = asset.Get("minVersion");
  if (least.IsThere() && least.GetText("") != "2.0")
  {
    least.FailExpecting("at most \"2.0\"");
  }
}

//------------------------------------------------------------------------------
void GltfContainer::CheckExtensions() const
{
  const GltfValue required = this->Get("extensionsRequired");
  for (std::size_t i = 0; i < required.GetSize(); ++i)
  {
    const std::string name = required.At(i).GetText("");
    if (KnownExtensions.count(name) == 0)
    {
      required.At(i).Fail("is " + name + ", which is not supported, and the file requires it");
    }
  }
}

//------------------------------------------------------------------------------
GltfValue GltfContainer::Get(const char* key) const
{
  return GltfValue(&this->Json, "").Get(key);
}

//------------------------------------------------------------------------------
std::vector<std::string> GltfContainer::GetUnread() const
{
  std::vector<std::string> unread;
  const GltfValue used = this->Get("extensionsUsed");
  for (std::size_t i = 0; i < used.GetSize(); ++i)
  {
    const std::string name = used.At(i).GetText("");
    if (KnownExtensions.count(name) == 0)
    {
      unread.push_back(name);
    }
  }
  return unread;
}

//------------------------------------------------------------------------------
std::string GltfContainer::FindNamed(const std::string& uri) const
{
  const std::filesystem::path folder = std::filesystem::path(this->Path).parent_path();
  std::error_code unknown;
  const std::string named = (folder / DecodeUri(uri)).string();
  const bool isCoded = std::filesystem::exists(named, unknown) ||
    !std::filesystem::exists(folder / uri, unknown); // some writers do not escape names
  return isCoded ? named : (folder / uri).string();
}

//------------------------------------------------------------------------------
std::string GltfContainer::FindObstacle(std::size_t image) const
{
  const std::string uri = this->Get("images").At(image).Get("uri").GetText("");
  return uri.empty() || HasScheme(uri) ? "" : this->Allowed.FindObstacle(this->FindNamed(uri));
}

//------------------------------------------------------------------------------
std::vector<unsigned char> GltfContainer::ReadUri(const GltfValue& owner, const std::string& uri)
{
  std::vector<unsigned char> bytes;
  if (uri.rfind("data:", 0) != 0)
  {
    if (HasScheme(uri))
    {
      owner.Fail("names " + uri + ", expected a file beside it or data: with base64");
    }
    const std::string named = this->FindNamed(uri);
    const std::string obstacle = this->Allowed.FindObstacle(named);
    if (!obstacle.empty())
    {
      owner.Fail("names " + DecodeUri(uri) + ": " + obstacle);
    }
    this->Sources.Add(named);
    try
    {
      bytes = ReadBytes(named, this->Read);
    }
    catch (const GltfError& error)
    {
      owner.Fail("names " + DecodeUri(uri) + ", which " + error.what());
    }
    return bytes;
  }
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos)
  {
    owner.Fail("has data: without a comma before the bytes");
  }
  const std::string kind = uri.substr(0, comma);
  const bool coded = kind.size() >= 7 && kind.compare(kind.size() - 7, 7, ";base64") == 0;
  if (!coded)
  {
    const std::string plain = DecodeUri(uri.substr(comma + 1));
    return std::vector<unsigned char>(plain.begin(), plain.end());
  }
  if (!DecodeBase64(uri.data() + comma + 1, uri.size() - comma - 1, bytes))
  {
    owner.Fail("has data: that is not base64");
  }
  return bytes;
}

//------------------------------------------------------------------------------
GltfBytes GltfContainer::GetBuffer(std::size_t buffer)
{
  const GltfValue value = this->Get("buffers").At(buffer);
  const std::size_t length = value.Get("byteLength").GetCount(0, 1);
  const GltfValue uri = value.Get("uri");
  const auto [found, isNew] = this->Buffers.try_emplace(buffer);
  if (isNew && uri.IsThere())
  {
    found->second = this->ReadUri(value, uri.GetText(""));
  }
  else if (isNew && buffer == 0)
  {
    found->second = std::move(this->Chunk);
  }
  if (found->second.size() < length)
  {
    value.Fail("has " + std::to_string(found->second.size()) + " bytes, but its byteLength is " +
      std::to_string(length));
  }
  return { found->second.data(), length };
}

//------------------------------------------------------------------------------
GltfBytes GltfContainer::GetView(std::size_t view)
{
  const GltfValue value = this->Get("bufferViews").At(view);
  const int buffer = value.Get("buffer").GetIndex("buffers", this->Get("buffers").GetSize());
  if (buffer < 0)
  {
    value.Get("buffer").FailExpecting("a number");
  }
  const GltfBytes whole = this->GetBuffer(static_cast<std::size_t>(buffer));
  const std::size_t offset = value.Get("byteOffset").GetCount(0);
  const std::size_t length = value.Get("byteLength").GetCount(0, 1);
  if (offset > whole.Size || length > whole.Size - offset)
  {
    value.Fail("has " + std::to_string(length) + " bytes from byte " + std::to_string(offset) +
      ", but buffers[" + std::to_string(buffer) + "] has " + std::to_string(whole.Size) + " bytes");
  }
  return { whole.Data + offset, length };
}

//------------------------------------------------------------------------------
GltfBytes GltfContainer::GetImage(std::size_t image, std::string& name)
{
  const GltfValue value = this->Get("images").At(image);
  const GltfValue uri = value.Get("uri");
  const std::string text = uri.GetText("");
  name = uri.IsThere() && text.rfind("data:", 0) != 0 ? DecodeUri(text) : value.GetPlace();
  if (!uri.IsThere())
  {
    const int view =
      value.Get("bufferView").GetIndex("bufferViews", this->Get("bufferViews").GetSize());
    if (view < 0)
    {
      value.Fail("has neither uri nor bufferView, expected one of them");
    }
    return this->GetView(static_cast<std::size_t>(view));
  }
  const auto [found, isNew] = this->Images.try_emplace(image);
  if (isNew)
  {
    found->second = this->ReadUri(value, text);
  }
  return { found->second.data(), found->second.size() };
}
}
