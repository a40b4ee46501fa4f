// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkinPeer.h"

#include "vtkGLTFReader.h"
#include "vtkNew.h"

#include <chrono>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace relievoBench
{
namespace
{
// The binary chunk of a .glb, and its views and accessors.
struct Chunk
{
  std::string Bytes;
  std::ostringstream Views;
  std::ostringstream Accessors;
  int Count = 0;

  template <typename Value>
  int Add(const std::vector<Value>& values, int component, const std::string& type, int parts,
    const std::string& more = "")
  {
    const std::size_t size = sizeof(Value) * values.size();
    this->Views << (this->Count ? "," : "") << R"({"buffer":0,"byteOffset":)" << this->Bytes.size()
                << R"(,"byteLength":)" << size << "}";
    this->Accessors << (this->Count ? "," : "") << R"({"bufferView":)" << this->Count
                    << R"(,"componentType":)" << component << R"(,"count":)"
                    << values.size() / static_cast<std::size_t>(parts) << R"(,"type":")" << type
                    << "\"" << more << "}";
    this->Bytes.append(reinterpret_cast<const char*>(values.data()), size);
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
void WriteSkinned(const std::string& path, const SkinnedPoints& mesh)
{
  constexpr int isFloat = 5126;
  constexpr int isShort = 5123;
  const auto bones = static_cast<std::size_t>(mesh.Bones);
  Chunk chunk;
  chunk.Add(mesh.Points, isFloat, "VEC3", 3);
  chunk.Add(mesh.Normals, isFloat, "VEC3", 3);
  chunk.Add(mesh.Joints, isShort, "VEC4", 4);
  chunk.Add(mesh.Weights, isFloat, "VEC4", 4);
  std::vector<float> offsets;
  for (std::size_t i = 0; i < 16 * bones; ++i)
  {
    offsets.push_back(i % 16 % 5 == 0 ? 1.f : 0.f);
  }
  chunk.Add(offsets, isFloat, "MAT4", 16);
  chunk.Add(std::vector<float>{ 0.f, 1.f }, isFloat, "SCALAR", 1, R"(,"min":[0],"max":[1])");
  std::ostringstream nodes;
  std::ostringstream joints;
  std::ostringstream samplers;
  std::ostringstream channels;
  for (std::size_t i = 0; i < bones; ++i)
  {
    const char* comma = i ? "," : "";
    const std::vector<float> turn(mesh.Turns.begin() + static_cast<std::ptrdiff_t>(4 * i),
      mesh.Turns.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
    std::vector<float> keys = { 0.f, 0.f, 0.f, 1.f };
    keys.insert(keys.end(), turn.begin(), turn.end());
    const int output = chunk.Add(keys, isFloat, "VEC4", 4);
    nodes << R"(,{"name":"bone )" << i << "\"}";
    joints << comma << i + 1;
    samplers << comma << R"({"input":5,"output":)" << output << "}";
    channels << comma << R"({"sampler":)" << i << R"(,"target":{"node":)" << i + 1
             << R"(,"path":"rotation"}})";
  }
  std::ostringstream roots;
  for (std::size_t i = 0; i <= bones; ++i)
  {
    roots << (i ? "," : "") << i;
  }
  std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots.str() +
    R"(]}],"nodes":[{"mesh":0,"skin":0})" + nodes.str() +
    R"(],"meshes":[{"primitives":[{"mode":0,"attributes":{"POSITION":0,"NORMAL":1,"JOINTS_0":2,)" +
    R"("WEIGHTS_0":3}}]}],"skins":[{"inverseBindMatrices":4,"joints":[)" + joints.str() +
    R"(]}],"buffers":[{"byteLength":)" + std::to_string(chunk.Bytes.size()) +
    R"(}],"bufferViews":[)" + chunk.Views.str() + R"(],"accessors":[)" + chunk.Accessors.str() +
    R"(],"animations":[{"samplers":[)" + samplers.str() + R"(],"channels":[)" + channels.str() +
    "]}]}";
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string head = "glTF";
  AppendNumber(head, 2);
  AppendNumber(head, 12 + 8 + text.size() + 8 + chunk.Bytes.size());
  AppendNumber(head, text.size());
  head += "JSON" + text;
  AppendNumber(head, chunk.Bytes.size());
  head += std::string("BIN\0", 4);
  std::ofstream(path, std::ios::binary) << head << chunk.Bytes;
}

//------------------------------------------------------------------------------
std::vector<double> TimeVtkReader(const std::string& path, int rounds)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  if (reader->GetNumberOfAnimations() != 1)
  {
    return {};
  }
  reader->EnableAnimation(0);
  reader->UpdateTimeStep(0.);
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    reader->UpdateTimeStep((i + 1.) / (rounds + 1.));
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    times.push_back(time.count());
  }
  return times;
}
}
