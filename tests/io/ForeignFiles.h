// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForeignFiles.h
 * @brief EXR files as other programs write them: made by OpenEXR itself, pixels from formulas.
 *
 * The pixel at (x, y) of the file, y down, has the value Pixel(channel, x, y) in every channel.
 */
#ifndef ForeignFiles_h
#define ForeignFiles_h

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPixelType.h>
#include <OpenEXR/ImfTileDescription.h>

#include <string>
#include <vector>

namespace ioTest
{
/** A whole number that half, float and unsigned int all hold, different for neighbouring pixels. */
int Pixel(int channel, int x, int y);

/** A header with these channels; the windows are given by their corners. */
Imf::Header MakeHeader(const Imath::Box2i& display, const Imath::Box2i& data,
  const std::vector<std::string>& channels, Imf::PixelType type = Imf::FLOAT,
  Imf::Compression compression = Imf::ZIP_COMPRESSION);

/** Writes scan lines. Channels are numbered in the order of their names. */
void WriteScanLines(const std::string& file, const Imf::Header& header);

/** Writes tiles, on every level of the mode; levels but the first hold other numbers. */
void WriteTiles(const std::string& file, Imf::Header header, int tileWidth, int tileHeight,
  Imf::LevelMode mode, Imf::LevelRoundingMode rounding = Imf::ROUND_DOWN);

/** Writes several parts; a header with a tile description becomes a tiled part. Channels go on
 * being numbered from part to part. */
void WriteParts(const std::string& file, std::vector<Imf::Header> headers);

/** Writes one part of deep scan lines with one sample in every pixel. */
void WriteDeep(const std::string& file, const Imf::Header& header);
}

#endif
