// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExrSeeds.h"

#include "ForeignFiles.h"
#include "ImageTools.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkNew.h>
#include <vtkPointData.h>

#include <OpenEXR/ImfChannelList.h>

#include <cstdio>

namespace exrFuzz
{
namespace
{
using Imath::Box2i;
using Imath::V2i;

const int NumberOfCompressions = 10;

Imf::Header MixedHeader(const Box2i& window, int compression)
{
  Imf::Header header = ioTest::MakeHeader(
    window, window, { "R", "G", "B", "A" }, Imf::HALF, static_cast<Imf::Compression>(compression));
  header.channels().insert("depth.Z", Imf::Channel(Imf::FLOAT));
  header.channels().insert("cell.id", Imf::Channel(Imf::UINT));
  return header;
}

void WriteLayers(const std::string& file, int compression)
{
  auto image = ioTest::MakeLayers(11, 9);
  if (compression >= vtkRelievoEXRWriter::DWAA)
  {
    // Channels about which DWA would warn.
    for (const char* name : { "normal", "geometric_normal", "position", "U velocity", "uv" })
    {
      image->GetPointData()->RemoveArray(name);
    }
  }
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->SetCompression(compression);
  writer->Write();
}
}

//------------------------------------------------------------------------------
std::vector<std::string> MakeSeeds(const std::string& folder)
{
  const std::string file = folder + "/seed.exr";
  std::vector<std::string> seeds;
  const auto keep = [&] { seeds.push_back(ioTest::Bytes(file)); };
  const Box2i window(V2i(-2, 3), V2i(16, 36));
  for (int c = 0; c < NumberOfCompressions; ++c)
  {
    ioTest::WriteScanLines(file, MixedHeader(window, c));
    keep();
    ioTest::WriteTiles(file, MixedHeader(window, c), 8, 16, Imf::ONE_LEVEL);
    keep();
    WriteLayers(file, c);
    keep();
  }
  for (const Imf::LevelMode mode : { Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS })
  {
    ioTest::WriteTiles(file, MixedHeader(window, Imf::ZIP_COMPRESSION), 8, 8, mode, Imf::ROUND_UP);
    keep();
  }
  Imf::Header downward = MixedHeader(window, Imf::RLE_COMPRESSION);
  downward.lineOrder() = Imf::DECREASING_Y;
  ioTest::WriteScanLines(file, downward);
  keep();
  for (const Imf::Compression compression :
    { Imf::NO_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::DWAA_COMPRESSION })
  {
    Imf::Header tiled = MixedHeader(window, compression);
    tiled.setTileDescription(Imf::TileDescription(8, 8, Imf::MIPMAP_LEVELS));
    ioTest::WriteParts(
      file, { MixedHeader(window, compression), tiled, MixedHeader(window, Imf::ZIP_COMPRESSION) });
    keep();
  }
  const Box2i even(V2i(0, 0), V2i(15, 15));
  Imf::Header chroma = ioTest::MakeHeader(even, even, { "Y" }, Imf::HALF, Imf::B44_COMPRESSION);
  chroma.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
  ioTest::WriteScanLines(file, chroma);
  keep();
  ioTest::WriteDeep(file, ioTest::MakeHeader(even, even, { "Z" }));
  keep();
  std::remove(file.c_str());
  return seeds;
}
}
