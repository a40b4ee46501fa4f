// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// exrDump FILE.exr RAW: reads an EXR file with OpenEXR's own C++ interface and nothing of Relievo.
// The header goes to the standard output as JSON (width, height, compression, channels with name
// and type as stored, attributes with name and type; those of numbers, triples and matrices with
// their values); the channels go to RAW one after the other, top row first, half and float as
// float32, uint as uint32.

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
const char* Name(Imf::PixelType type)
{
  return type == Imf::UINT ? "uint" : type == Imf::HALF ? "half" : "float";
}

std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    quoted += letter == '"' || letter == '\\' ? "\\" : "";
    quoted += letter == '\n' ? ' ' : letter;
  }
  return quoted + '"';
}

template <typename Matrix>
std::string Numbers(const Matrix& matrix)
{
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < 16; ++i)
  {
    text << (i ? ", " : "[") << matrix[i / 4][i % 4];
  }
  return text.str() + "]";
}

std::string Value(const Imf::Attribute& attribute)
{
  std::ostringstream text;
  text.precision(17);
  if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&attribute))
  {
    text << number->value();
  }
  else if (const auto* precise = dynamic_cast<const Imf::DoubleAttribute*>(&attribute))
  {
    text << precise->value();
  }
  else if (const auto* words = dynamic_cast<const Imf::StringAttribute*>(&attribute))
  {
    text << Quote(words->value());
  }
  else if (const auto* matrix = dynamic_cast<const Imf::M44fAttribute*>(&attribute))
  {
    text << Numbers(matrix->value());
  }
  else if (const auto* preciseMatrix = dynamic_cast<const Imf::M44dAttribute*>(&attribute))
  {
    text << Numbers(preciseMatrix->value());
  }
  else if (const auto* triple = dynamic_cast<const Imf::V3dAttribute*>(&attribute))
  {
    const Imath::V3d& value = triple->value();
    text << '[' << value.x << ", " << value.y << ", " << value.z << ']';
  }
  else
  {
    text << "null";
  }
  return text.str();
}

void Dump(const char* path, const char* rawPath)
{
  Imf::InputFile file(path);
  const Imf::Header& header = file.header();
  const Imath::Box2i box = header.dataWindow();
  const int width = box.max.x - box.min.x + 1;
  const int height = box.max.y - box.min.y + 1;
  std::cout << "{\"width\": " << width << ", \"height\": " << height
            << ", \"compression\": " << static_cast<int>(header.compression())
            << ",\n\"channels\": [";
  std::vector<std::vector<std::uint32_t>> planes;
  Imf::FrameBuffer buffer;
  const char* separator = "";
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
  {
    const Imf::PixelType type = channel.channel().type;
    std::cout << separator << "{\"name\": " << Quote(channel.name()) << ", \"type\": \""
              << Name(type) << "\"}";
    separator = ", ";
    planes.emplace_back(static_cast<std::size_t>(width) * height);
    buffer.insert(channel.name(),
      Imf::Slice::Make(type == Imf::UINT ? Imf::UINT : Imf::FLOAT, planes.back().data(), box));
  }
  std::cout << "],\n\"attributes\": {";
  separator = "";
  for (auto entry = header.begin(); entry != header.end(); ++entry)
  {
    std::cout << separator << Quote(entry.name())
              << ": {\"type\": " << Quote(entry.attribute().typeName())
              << ", \"value\": " << Value(entry.attribute()) << "}";
    separator = ",\n";
  }
  std::cout << "}}\n";
  file.setFrameBuffer(buffer);
  file.readPixels(box.min.y, box.max.y);
  std::ofstream raw(rawPath, std::ios::binary);
  for (const std::vector<std::uint32_t>& plane : planes)
  {
    raw.write(reinterpret_cast<const char*>(plane.data()),
      static_cast<std::streamsize>(plane.size() * sizeof(std::uint32_t)));
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: exrDump FILE.exr RAW\n";
    return 2;
  }
  try
  {
    Dump(argv[1], argv[2]);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "exrDump: " << error.what() << '\n';
    return 1;
  }
}
