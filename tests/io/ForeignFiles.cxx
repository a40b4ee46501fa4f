// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ForeignFiles.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <deque>

namespace ioTest
{
namespace
{
// The pixels of every channel in a window, and the frame buffer over them.
struct Pixels
{
  std::deque<std::vector<char>> Data;
  Imf::FrameBuffer Buffer;

  Pixels(const Imf::Header& header, const Imath::Box2i& window, int firstChannel, int shift)
  {
    int index = firstChannel;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it, ++index)
    {
      const Imf::Channel& channel = it.channel();
      const int width = (window.max.x - window.min.x) / channel.xSampling + 1;
      const int height = (window.max.y - window.min.y) / channel.ySampling + 1;
      const std::size_t size = channel.type == Imf::HALF ? 2 : 4;
      this->Data.emplace_back(size * width * height);
      char* to = this->Data.back().data();
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x, to += size)
        {
          const int value = shift +
            Pixel(
              index, window.min.x + x * channel.xSampling, window.min.y + y * channel.ySampling);
          if (channel.type == Imf::UINT)
          {
            *reinterpret_cast<unsigned int*>(to) = value;
          }
          else if (channel.type == Imf::FLOAT)
          {
            *reinterpret_cast<float*>(to) = static_cast<float>(value);
          }
          else
          {
            *reinterpret_cast<half*>(to) = half(static_cast<float>(value));
          }
        }
      }
      this->Buffer.insert(it.name(),
        Imf::Slice::Make(channel.type, this->Data.back().data(), window, size, size * width,
          channel.xSampling, channel.ySampling));
    }
  }
};

template <typename TiledFile>
void WriteAllTiles(TiledFile& file, const Imf::Header& header, int firstChannel)
{
  for (int ly = 0; ly < file.numYLevels(); ++ly)
  {
    for (int lx = 0; lx < file.numXLevels(); ++lx)
    {
      if (file.isValidLevel(lx, ly))
      {
        const int shift = lx + ly > 0 ? 1000 : 0;
        Pixels pixels(header, file.dataWindowForLevel(lx, ly), firstChannel, shift);
        file.setFrameBuffer(pixels.Buffer);
        file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
      }
    }
  }
}

int NumberOfChannels(const Imf::Header& header)
{
  int count = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
  {
    ++count;
  }
  return count;
}
}

//------------------------------------------------------------------------------
int Pixel(int channel, int x, int y)
{
  return 7 * channel + (x & 31) + 32 * (y & 15);
}

//------------------------------------------------------------------------------
Imf::Header MakeHeader(const Imath::Box2i& display, const Imath::Box2i& data,
  const std::vector<std::string>& channels, Imf::PixelType type, Imf::Compression compression)
{
  Imf::Header header(display, data);
  header.compression() = compression;
  for (const std::string& channel : channels)
  {
    header.channels().insert(channel, Imf::Channel(type));
  }
  return header;
}

//------------------------------------------------------------------------------
void WriteScanLines(const std::string& name, const Imf::Header& header)
{
  Pixels pixels(header, header.dataWindow(), 0, 0);
  Imf::OutputFile file(name.c_str(), header);
  file.setFrameBuffer(pixels.Buffer);
  file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
}

//------------------------------------------------------------------------------
void WriteTiles(const std::string& name, Imf::Header header, int tileWidth, int tileHeight,
  Imf::LevelMode mode, Imf::LevelRoundingMode rounding)
{
  header.setTileDescription(Imf::TileDescription(tileWidth, tileHeight, mode, rounding));
  Imf::TiledOutputFile file(name.c_str(), header);
  WriteAllTiles(file, header, 0);
}

//------------------------------------------------------------------------------
void WriteParts(const std::string& name, std::vector<Imf::Header> headers)
{
  for (std::size_t i = 0; i < headers.size(); ++i)
  {
    headers[i].setName("part" + std::to_string(i));
    headers[i].setType(headers[i].hasTileDescription() ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  }
  Imf::MultiPartOutputFile file(name.c_str(), headers.data(), static_cast<int>(headers.size()));
  int channel = 0;
  for (int i = 0; i < static_cast<int>(headers.size()); ++i)
  {
    if (headers[i].hasTileDescription())
    {
      Imf::TiledOutputPart part(file, i);
      WriteAllTiles(part, headers[i], channel);
    }
    else
    {
      Pixels pixels(headers[i], headers[i].dataWindow(), channel, 0);
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(pixels.Buffer);
      part.writePixels(headers[i].dataWindow().max.y - headers[i].dataWindow().min.y + 1);
    }
    channel += NumberOfChannels(headers[i]);
  }
}

//------------------------------------------------------------------------------
void WriteDeep(const std::string& name, const Imf::Header& header)
{
  Imf::Header deep = header;
  deep.setType(Imf::DEEPSCANLINE);
  deep.compression() = Imf::ZIPS_COMPRESSION;
  const Imath::Box2i window = deep.dataWindow();
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  std::vector<unsigned int> counts(width * height, 1);
  std::vector<float> samples(width * height, 2.0f);
  std::vector<float*> pointers;
  pointers.reserve(samples.size());
  for (float& sample : samples)
  {
    pointers.push_back(&sample);
  }
  Imf::DeepFrameBuffer buffer;
  const std::ptrdiff_t offset = window.min.x + static_cast<std::ptrdiff_t>(window.min.y) * width;
  buffer.insertSampleCountSlice(
    Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data() - offset), sizeof(unsigned int),
      sizeof(unsigned int) * width));
  for (auto it = deep.channels().begin(); it != deep.channels().end(); ++it)
  {
    buffer.insert(it.name(),
      Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data() - offset), sizeof(float*),
        sizeof(float*) * width, sizeof(float)));
  }
  Imf::DeepScanLineOutputFile file(name.c_str(), deep);
  file.setFrameBuffer(buffer);
  file.writePixels(height);
}
}
