// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfScene.h"

#include <vtksys/Base64.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

namespace relievoTest
{
namespace
{
// A buffer with its views and accessors.
struct Buffer
{
  std::string Bytes;
  std::ostringstream Views;
  std::ostringstream Accessors;
  int Count = 0;

  int Add(const std::vector<float>& values, int components, const std::string& more = "")
  {
    const char* const types[] = { "", "SCALAR", "VEC2", "VEC3", "VEC4" };
    const char* comma = this->Count ? "," : "";
    this->Views << comma << R"({"buffer":0,"byteOffset":)" << this->Bytes.size()
                << R"(,"byteLength":)" << 4 * values.size() << "}";
    this->Accessors << comma << R"({"bufferView":)" << this->Count
                    << R"(,"componentType":5126,"count":)"
                    << values.size() / static_cast<std::size_t>(components) << R"(,"type":")"
                    << types[components] << "\"" << more << "}";
    this->Bytes.append(reinterpret_cast<const char*>(values.data()), 4 * values.size());
    return this->Count++;
  }
};

void AppendNumber(std::string& to, std::size_t value)
{
  const auto number = static_cast<std::uint32_t>(value);
  to.append(reinterpret_cast<const char*>(&number), 4);
}
}

//------------------------------------------------------------------------------
std::string EncodeBytes(const std::string& bytes)
{
  std::vector<unsigned char> text(4 * (bytes.size() / 3 + 2));
  const std::size_t length = vtksysBase64_Encode(
    reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), text.data(), 0);
  return std::string(reinterpret_cast<const char*>(text.data()), length);
}

//------------------------------------------------------------------------------
bool IsGlb(const std::string& path)
{
  return path.size() > 4 && path.substr(path.size() - 4) == ".glb";
}

//------------------------------------------------------------------------------
std::string WriteGltfUri(const std::string& path, const std::string& bytes)
{
  return IsGlb(path)
    ? ""
    : R"(,"uri":"data:application/octet-stream;base64,)" + EncodeBytes(bytes) + "\"";
}

//------------------------------------------------------------------------------
void WriteGltfFile(const std::string& path, std::string text, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  if (!IsGlb(path))
  {
    file << text;
    return;
  }
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string whole = "glTF";
  AppendNumber(whole, 2);
  AppendNumber(whole, 12 + 8 + text.size() + 8 + bytes.size());
  AppendNumber(whole, text.size());
  whole += "JSON" + text;
  AppendNumber(whole, bytes.size());
  whole += std::string("BIN\0", 4) + bytes;
  file << whole;
}

//------------------------------------------------------------------------------
void WriteGltf(const std::string& path, const std::vector<GltfTrack>& tracks, bool named)
{
  Buffer buffer;
  buffer.Add({ 1.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 0.f, 1.f }, 3, R"(,"min":[1,0,0],"max":[2,0,1])");
  std::ostringstream samplers;
  std::ostringstream channels;
  for (std::size_t i = 0; i < tracks.size(); ++i)
  {
    const GltfTrack& track = tracks[i];
    const int input = buffer.Add(track.Times, 1,
      ",\"min\":[" + std::to_string(track.Times.front()) + "],\"max\":[" +
        std::to_string(track.Times.back()) + "]");
    const int output = buffer.Add(track.Values, track.Path == "rotation" ? 4 : 3);
    samplers << (i ? "," : "") << R"({"input":)" << input << R"(,"output":)" << output
             << R"(,"interpolation":")" << track.Mode << "\"}";
    channels << (i ? "," : "") << R"({"sampler":)" << i << R"(,"target":{"node":0,"path":")"
             << track.Path << "\"}}";
  }
  const std::string text =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" +
    std::string(named ? R"("name":"arm",)" : "") +
    R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
    R"("buffers":[{"byteLength":)" + std::to_string(buffer.Bytes.size()) +
    WriteGltfUri(path, buffer.Bytes) + "}]," + R"("bufferViews":[)" + buffer.Views.str() +
    R"(],"accessors":[)" + buffer.Accessors.str() +
    R"(],"animations":[{"name":"move","samplers":[)" + samplers.str() + R"(],"channels":[)" +
    channels.str() + "]}]}";
  WriteGltfFile(path, text, buffer.Bytes);
}
}
