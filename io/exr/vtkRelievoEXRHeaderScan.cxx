// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRHeaderScan.h"

#include "vtkErrorCode.h"
#include "vtkRelievoEXRChannels.h"
#include "vtkRelievoEXRFailure.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace relievo::exr
{
namespace
{
constexpr int MostParts = 1024;
constexpr int MostAttributes = 4096;
constexpr uint64_t MultiPartFlag = 0x1000;

// Sizes in bytes of the attribute types with a fixed size. OpenEXR reads a value by its type and
// ignores the size written before it: with another size, it would misread the following bytes.
const std::map<std::string, uint64_t> FixedSizes = { { "box2f", 16 }, { "box2i", 16 },
  { "chromaticities", 32 }, { "compression", 1 }, { "deepImageState", 1 }, { "double", 8 },
  { "envmap", 1 }, { "float", 4 }, { "int", 4 }, { "keycode", 28 }, { "lineOrder", 1 },
  { "m33d", 72 }, { "m33f", 36 }, { "m44d", 128 }, { "m44f", 64 }, { "rational", 8 },
  { "tiledesc", 9 }, { "timecode", 8 }, { "v2d", 16 }, { "v2f", 8 }, { "v2i", 8 }, { "v3d", 24 },
  { "v3f", 12 }, { "v3i", 12 } };

Failure Broken(const std::string& what)
{
  return Failure(
    vtkErrorCode::FileFormatError, "its header is broken: " + what + "; write or fetch it again");
}

uint64_t ReadInt(InputStream& stream, int bytes)
{
  unsigned char raw[8] = {};
  stream.read(reinterpret_cast<char*>(raw), bytes);
  uint64_t value = 0;
  for (int i = 0; i < bytes; ++i)
  {
    value |= static_cast<uint64_t>(raw[i]) << (8 * i);
  }
  return value;
}

std::string ReadName(InputStream& stream, const char* what)
{
  std::string name;
  for (char c = 0;;)
  {
    stream.read(&c, 1);
    if (c == 0)
    {
      return name;
    }
    if (name.size() == LongestName)
    {
      throw Broken(std::string("the name of ") + what + " has no end");
    }
    name.push_back(c);
  }
}

void ScanChannels(InputStream& stream, uint64_t end)
{
  const uint64_t channelBytes = 16; // type, linearity, padding, sampling in x and y
  for (int count = 0;; ++count)
  {
    const std::string name = ReadName(stream, "a channel");
    if (name.empty())
    {
      break;
    }
    if (count == MostChannels)
    {
      throw Broken("it lists more than " + std::to_string(MostChannels) + " channels");
    }
    stream.seekg(stream.tellg() + channelBytes);
  }
  if (stream.tellg() != end)
  {
    throw Broken("its list of channels does not end where it should");
  }
}

void ScanStrings(InputStream& stream, uint64_t end, const std::string& name)
{
  while (stream.tellg() < end)
  {
    const uint64_t left = end - stream.tellg();
    const uint64_t length = left >= 4 ? ReadInt(stream, 4) : left;
    if (left < 4 || length > left - 4)
    {
      throw Broken("the strings of attribute " + Shown(name) + " are longer than itself");
    }
    stream.seekg(stream.tellg() + length);
  }
}

// Scans one attribute; false at the end of a header.
bool ScanAttribute(InputStream& stream)
{
  const std::string name = ReadName(stream, "an attribute");
  if (name.empty())
  {
    return false;
  }
  const std::string type = ReadName(stream, "an attribute's type");
  const uint64_t size = ReadInt(stream, 4);
  if (size > stream.GetRemaining() || size > 0x7fffffff)
  {
    throw Failure(vtkErrorCode::PrematureEndOfFileError,
      "its header is broken or cut off: attribute " + Shown(name) + " claims " +
        std::to_string(size) + " bytes, but only " + std::to_string(stream.GetRemaining()) +
        " follow; write or fetch it again");
  }
  const uint64_t end = stream.tellg() + size;
  const auto fixed = FixedSizes.find(type);
  if (fixed != FixedSizes.end() && fixed->second != size)
  {
    throw Broken("attribute " + Shown(name) + " has " + std::to_string(size) + " bytes, but " +
      type + " has " + std::to_string(fixed->second));
  }
  if (type == "floatvector" && size % 4 != 0)
  {
    throw Broken("attribute " + Shown(name) + " ends in the middle of a float");
  }
  if (type == "chlist")
  {
    ScanChannels(stream, end);
  }
  else if (type == "stringvector")
  {
    ScanStrings(stream, end, name);
  }
  else if (type == "preview")
  {
    const uint64_t width = size >= 8 ? ReadInt(stream, 4) : 0;
    const uint64_t height = size >= 8 ? ReadInt(stream, 4) : 0;
    if (size < 8 || width > 0x7fffffff || height > 0x7fffffff ||
      (width != 0 && height > (size - 8) / 4 / width) || width * height * 4 + 8 != size)
    {
      throw Broken("its preview image has the wrong size");
    }
  }
  else if (type == "idmanifest")
  {
    // OpenEXR 3.1 reads 4 bytes too many and loses its position.
    throw Failure(vtkErrorCode::FileFormatError,
      "it holds an ID manifest, which cannot be read; remove the attribute " + Shown(name));
  }
  stream.seekg(end);
  return true;
}

struct Demand
{
  double Chunks;       // entries of the table of offsets, 8 bytes each
  double Bytes;        // of all pixels, unpacked
  double WorkingBytes; // of the largest piece unpacked at once
};

uint64_t LevelSize(uint64_t size, int level, Imf::LevelRoundingMode rounding)
{
  const uint64_t divisor = uint64_t(1) << level;
  const uint64_t rounded = rounding == Imf::ROUND_UP ? size + divisor - 1 : size;
  return std::max<uint64_t>(1, rounded / divisor);
}

int NumberOfLevels(uint64_t size, Imf::LevelRoundingMode rounding)
{
  int levels = 1;
  for (uint64_t s = size; s > 1; s = rounding == Imf::ROUND_UP ? (s + 1) / 2 : s / 2)
  {
    ++levels;
  }
  return levels;
}

double NumberOfPieces(uint64_t size, uint64_t piece)
{
  const uint64_t pieces = (size + piece - 1) / piece;
  return static_cast<double>(pieces);
}

double NumberOfTiles(uint64_t width, uint64_t height, const Imf::TileDescription& tiles)
{
  const auto across = [&](int level) {
    return NumberOfPieces(LevelSize(width, level, tiles.roundingMode), tiles.xSize);
  };
  const auto down = [&](int level) {
    return NumberOfPieces(LevelSize(height, level, tiles.roundingMode), tiles.ySize);
  };
  if (tiles.mode == Imf::RIPMAP_LEVELS)
  {
    double x = 0;
    double y = 0;
    for (int i = 0; i < NumberOfLevels(width, tiles.roundingMode); ++i)
    {
      x += across(i);
    }
    for (int i = 0; i < NumberOfLevels(height, tiles.roundingMode); ++i)
    {
      y += down(i);
    }
    return x * y;
  }
  const int levels = tiles.mode == Imf::MIPMAP_LEVELS
    ? NumberOfLevels(std::max(width, height), tiles.roundingMode)
    : 1;
  double count = 0;
  for (int i = 0; i < levels; ++i)
  {
    count += across(i) * down(i);
  }
  return count;
}

Demand DemandOf(const Imf::Header& header)
{
  const Imath::Box2i& window = header.dataWindow();
  const uint64_t width = static_cast<int64_t>(window.max.x) - window.min.x + 1;
  const uint64_t height = static_cast<int64_t>(window.max.y) - window.min.y + 1;
  double bytesPerPixel = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
  {
    const double bytes = channel.channel().type == Imf::HALF ? 2 : 4;
    bytesPerPixel += bytes / channel.channel().xSampling / channel.channel().ySampling;
  }
  Demand demand{};
  demand.Bytes = static_cast<double>(width) * height * bytesPerPixel;
  if (header.hasType() && header.type() == Imf::TILEDIMAGE)
  {
    const Imf::TileDescription tiles = header.tileDescription();
    demand.Chunks = NumberOfTiles(width, height, tiles);
    // A tile, and a whole row of tiles.
    demand.WorkingBytes =
      bytesPerPixel * tiles.ySize * static_cast<double>(std::max<uint64_t>(tiles.xSize, width));
  }
  else
  {
    const uint64_t lines = LinesPerChunk(header.compression());
    demand.Chunks = NumberOfPieces(height, lines);
    demand.WorkingBytes = bytesPerPixel * static_cast<double>(width) * lines;
  }
  return demand;
}

// Largest number of bytes that one packed byte can represent.
double BestRatio(Imf::Compression compression)
{
  switch (compression)
  {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64; // 128 equal bytes in 2
    case Imf::DWAA_COMPRESSION:
    case Imf::DWAB_COMPRESSION:
      return 64 * 1100; // 8x8 halfs in one 2-byte symbol, and deflate on top
    default:
      return 1500; // deflate's 1032, and the bits that PXR24 drops
  }
}
}

//------------------------------------------------------------------------------
int LinesPerChunk(Imf::Compression compression)
{
  switch (compression)
  {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

//------------------------------------------------------------------------------
void ScanHeaders(InputStream& stream)
{
  char magic[4] = {};
  stream.read(magic, static_cast<int>(std::min<uint64_t>(4, stream.GetSize())));
  if (magic[0] != 0x76 || magic[1] != 0x2f || magic[2] != 0x31 || magic[3] != 0x01)
  {
    throw Failure(vtkErrorCode::UnrecognizedFileTypeError,
      "it is not an OpenEXR file (it does not begin with the bytes 76 2f 31 01); "
      "give the name of an .exr file");
  }
  const uint64_t version = ReadInt(stream, 4);
  if ((version & 0xff) > 2)
  {
    throw Failure(vtkErrorCode::UnrecognizedFileTypeError,
      "it is of version " + std::to_string(version & 0xff) +
        " of the OpenEXR format, but only versions 1 and 2 are known");
  }
  const bool multiPart = (version & MultiPartFlag) != 0;
  for (int part = 0;; ++part)
  {
    int attributes = 0;
    while (ScanAttribute(stream))
    {
      if (++attributes > MostAttributes)
      {
        throw Broken("it has more than " + std::to_string(MostAttributes) + " attributes");
      }
    }
    // The list of headers ends with an empty one.
    if (!multiPart || attributes == 0)
    {
      break;
    }
    if (part == MostParts)
    {
      throw Broken("it has more than " + std::to_string(MostParts) + " parts");
    }
  }
  stream.seekg(0);
}

//------------------------------------------------------------------------------
void CheckPlausible(const std::vector<const Imf::Header*>& parts, uint64_t fileSize)
{
  // Small pictures may have large tiles: this much memory for unpacking is always allowed.
  const double freeBytes = 128.0 * 1024 * 1024;
  double packedBytes = 0;
  for (const Imf::Header* header : parts)
  {
    const Demand demand = DemandOf(*header);
    const double ratio = BestRatio(header->compression());
    packedBytes += demand.Chunks * 8 + demand.Bytes / ratio;
    const double working = demand.WorkingBytes / ratio;
    if (packedBytes > static_cast<double>(fileSize) ||
      (demand.WorkingBytes > freeBytes && working > static_cast<double>(fileSize)))
    {
      const Imath::Box2i window = header->dataWindow();
      throw Failure(vtkErrorCode::PrematureEndOfFileError,
        "its header promises " + std::to_string(int64_t(window.max.x) - window.min.x + 1) + " x " +
          std::to_string(int64_t(window.max.y) - window.min.y + 1) +
          " pixels, more than can be packed into its " + std::to_string(fileSize) +
          " bytes; it is broken or cut off: write or fetch it again");
    }
  }
}
}
