// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Radiance pictures (G. Ward, Real Pixels, Graphics Gems II, 1991): shared exponents, run-length
// coded or not, in any of the eight orders of scan lines. XYZ becomes RGB by Radiance's primaries.
// Values are those of the file: EXPOSURE and COLORCORR are not undone.
#include "vtkRelievoImageBytes.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace relievo::image
{
namespace
{
using Texel = std::array<unsigned char, 4>; // red, green, blue, exponent

struct HDRHeader
{
  bool XYZ = false;
  std::uint64_t Lines = 0;
  std::uint64_t Length = 0; // of a scan line
  int Orientation = 1;      // as in TIFF
  std::size_t Data = 0;
};

std::string ReadLine(const Bytes& bytes, std::size_t& at)
{
  std::string line;
  for (; bytes[at] != '\n'; ++at)
  {
    if (line.size() > 4096)
    {
      throw Failure("its header is damaged");
    }
    line += static_cast<char>(bytes[at]);
  }
  ++at;
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return line;
}

int FindOrientation(char slowSign, char slowAxis, char fastSign)
{
  if (slowAxis == 'Y') // lines are rows
  {
    return slowSign == '-' ? (fastSign == '+' ? 1 : 2) : (fastSign == '+' ? 4 : 3);
  }
  return slowSign == '+' ? (fastSign == '-' ? 5 : 8) : (fastSign == '-' ? 6 : 7);
}

HDRHeader ReadHDRHeader(const Bytes& bytes)
{
  HDRHeader head;
  std::size_t at = 0;
  ReadLine(bytes, at);
  bool formatted = false;
  for (std::string line = ReadLine(bytes, at); !line.empty(); line = ReadLine(bytes, at))
  {
    if (line.compare(0, 7, "FORMAT=") == 0)
    {
      const std::string format = line.substr(7, line.find_last_not_of(" \t") - 6);
      head.XYZ = format == "32-bit_rle_xyze";
      formatted = head.XYZ || format == "32-bit_rle_rgbe";
      if (!formatted)
      {
        throw Failure("its format '" + format.substr(0, 40) + "' is not read");
      }
    }
  }
  const std::string size = ReadLine(bytes, at);
  char slow[2][2] = {}; // sign and axis, each ending with 0
  char fast[2][2] = {};
  unsigned long long lines = 0;
  unsigned long long length = 0;
  const int found = std::sscanf(size.c_str(), "%1[-+]%1[XY] %10llu %1[-+]%1[XY] %10llu", slow[0],
    slow[1], &lines, fast[0], fast[1], &length);
  if (found != 6 || slow[1][0] == fast[1][0])
  {
    throw Failure("its size '" + size.substr(0, 40) + "' is not one of a Radiance picture");
  }
  head.Lines = lines;
  head.Length = length;
  head.Orientation = FindOrientation(slow[0][0], slow[1][0], fast[0][0]);
  head.Data = at;
  return head;
}

// Reads a scan line in the order of the file, and advances `at`.
void ReadScanLine(const Bytes& bytes, std::size_t& at, std::vector<Texel>& line)
{
  const std::size_t length = line.size();
  const bool parted = length >= 8 && length < 32768 && bytes[at] == 2 && bytes[at + 1] == 2 &&
    bytes.Big16(at + 2) == length;
  if (parted) // each component has its own runs
  {
    at += 4;
    for (int c = 0; c < 4; ++c)
    {
      for (std::size_t x = 0; x < length;)
      {
        const unsigned char code = bytes[at++];
        const std::size_t count = code > 128 ? code - 128 : code;
        if (count == 0 || count > length - x)
        {
          throw Failure("its data are damaged: a run leaves its scan line");
        }
        for (std::size_t i = 0; i < count; ++i)
        {
          line[x++][c] = code > 128 ? bytes[at] : bytes[at + i];
        }
        at += code > 128 ? 1 : count;
      }
    }
    return;
  }
  int shift = 0;
  for (std::size_t x = 0; x < length; at += 4)
  {
    const Texel texel = { bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3] };
    if (texel[0] != 1 || texel[1] != 1 || texel[2] != 1)
    {
      line[x++] = texel;
      shift = 0;
      continue;
    }
    // Repeats the previous texel by the exponent's count; consecutive runs count higher digits.
    const std::uint64_t count = shift > 24 ? length : static_cast<std::uint64_t>(texel[3]) << shift;
    if (x == 0 || count > length - x)
    {
      throw Failure("its data are damaged: a run leaves its scan line");
    }
    for (std::uint64_t i = 0; i < count; ++i, ++x)
    {
      line[x] = line[x - 1];
    }
    shift += 8;
  }
}

void PutColor(const Texel& texel, bool xyz, float* to)
{
  const float unit = texel[3] ? std::ldexp(1.f, texel[3] - 136) : 0.f;
  const float a = unit * texel[0];
  const float b = unit * texel[1];
  const float c = unit * texel[2];
  if (!xyz)
  {
    to[0] = a;
    to[1] = b;
    to[2] = c;
    return;
  }
  // For primaries (0.640, 0.330), (0.290, 0.600), (0.150, 0.060) and the white of equal energy.
  to[0] = 2.5653f * a - 1.1668f * b - 0.3984f * c;
  to[1] = -1.0221f * a + 1.9783f * b + 0.0438f * c;
  to[2] = 0.0747f * a - 0.2520f * b + 1.1772f * c;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeHDR(const Bytes& bytes)
{
  const HDRHeader head = ReadHDRHeader(bytes);
  CheckSize(head.Length, head.Lines, 3, sizeof(float));
  // Before memory is allocated: with nested runs, 4 bytes can represent a whole scan line.
  if (head.Lines > (bytes.Size() - head.Data) / 4)
  {
    ThrowCut();
  }
  auto image = MakeImage(head.Length, head.Lines, VTK_FLOAT, 3);
  std::vector<Texel> line(head.Length);
  std::size_t at = head.Data;
  for (std::uint64_t y = 0; y < head.Lines; ++y)
  {
    ReadScanLine(bytes, at, line);
    auto* to = Row<float>(image, head.Lines - 1 - y);
    for (const Texel& texel : line)
    {
      PutColor(texel, head.XYZ, to);
      to += 3;
    }
  }
  return Orient(image, head.Orientation);
}
}
