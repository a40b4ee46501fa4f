// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong with a PNG image's chunks: VTK's reader crashes on such images.
#ifndef vtkRelievoPngDamage_h
#define vtkRelievoPngDamage_h

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

// The checksum (CRC-32) of a PNG chunk: ISO 3309.
inline std::uint32_t vtkRelievoPngChecksum(const std::vector<char>& bytes)
{
  static const auto table = [] {
    std::vector<std::uint32_t> made(256);
    for (std::uint32_t i = 0; i < 256; ++i)
    {
      made[i] = i;
      for (int bit = 0; bit < 8; ++bit)
      {
        made[i] = (made[i] >> 1) ^ (made[i] & 1 ? 0xEDB88320U : 0U);
      }
    }
    return made;
  }();
  std::uint32_t sum = ~0U;
  for (const char byte : bytes)
  {
    sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (sum >> 8);
  }
  return ~sum;
}

// Empty if nothing is wrong with the whole of the stream.
inline std::string vtkRelievoFindPngDamage(std::istream& file)
{
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  file.seekg(8);
  auto number = [&file] {
    unsigned char bytes[4] = {};
    file.read(reinterpret_cast<char*>(bytes), 4);
    return (static_cast<std::uint32_t>(bytes[0]) << 24) | (bytes[1] << 16) | (bytes[2] << 8) |
      bytes[3];
  };
  for (std::uint64_t at = 8; at + 12 <= size;)
  {
    const std::uint64_t length = number();
    at += length + 12;
    if (at > size)
    {
      break;
    }
    std::vector<char> bytes(length + 4);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::uint32_t sum = number();
    if (sum != vtkRelievoPngChecksum(bytes))
    {
      return "it is damaged";
    }
    if (std::string(bytes.data(), 4) == "IEND")
    {
      return {};
    }
  }
  return "it ends too early";
}

#endif
