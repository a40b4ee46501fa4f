// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Portable Network Graphics: ISO/IEC 15948. All kinds of colour and depth, interlaced or not.
// Transparency of a palette or of one colour becomes an alpha component.
#include "vtkRelievoImageBytes.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace relievo::image
{
namespace
{
enum Color
{
  Grey = 0,
  RGB = 2,
  Palette = 3,
  GreyAlpha = 4,
  RGBA = 6
};

struct PNGHeader
{
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  int Depth = 0; // bits per sample
  int Kind = Grey;
  bool Interlaced = false;
  int Samples = 1; // per pixel, in the file
};

struct Transparency
{
  bool There = false;
  std::array<unsigned int, 3> Key{}; // the transparent colour, for grey and RGB
};

struct Content
{
  PNGHeader Head;
  std::vector<std::array<unsigned char, 4>> Colors; // the palette
  Transparency Alpha;
  std::vector<Bytes> Parts; // the compressed data
};

PNGHeader ReadPNGHeader(const Bytes& chunk)
{
  if (chunk.Size() != 13)
  {
    throw Failure("its header is damaged");
  }
  PNGHeader head;
  head.Width = chunk.Big32(0);
  head.Height = chunk.Big32(4);
  head.Depth = chunk[8];
  head.Kind = chunk[9];
  head.Interlaced = chunk[12] != 0;
  const int depths[7] = { 1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16 };
  const int samples[7] = { 1, 0, 3, 1, 2, 0, 4 };
  const bool depthIs =
    head.Depth == 1 || head.Depth == 2 || head.Depth == 4 || head.Depth == 8 || head.Depth == 16;
  if (head.Kind > RGBA || !depthIs || (depths[head.Kind] & head.Depth) == 0 || chunk[10] != 0 ||
    chunk[11] != 0 || chunk[12] > 1)
  {
    throw Failure("its header names a kind of PNG that there is not (colour " +
      std::to_string(head.Kind) + ", depth " + std::to_string(head.Depth) + ")");
  }
  if (head.Width > 0x7FFFFFFFU || head.Height > 0x7FFFFFFFU)
  {
    throw Failure("its header has a width or height beyond what PNG allows");
  }
  head.Samples = samples[head.Kind];
  // Includes the alpha component that transparency may add.
  const int components = head.Kind == Palette || head.Kind == RGB || head.Kind == RGBA ? 4 : 2;
  CheckSize(head.Width, head.Height, components, head.Depth == 16 ? 2 : 1);
  return head;
}

void ReadTransparency(const Bytes& chunk, Content& content)
{
  Transparency& alpha = content.Alpha;
  alpha.There = true;
  if (content.Head.Kind == Palette)
  {
    if (chunk.Size() > content.Colors.size())
    {
      throw Failure("its tRNS chunk is longer than its palette");
    }
    for (std::size_t i = 0; i < chunk.Size(); ++i)
    {
      content.Colors[i][3] = chunk[i];
    }
    return;
  }
  for (int i = 0; i < content.Head.Samples && content.Head.Samples <= 3; ++i)
  {
    alpha.Key[i] = chunk.Big16(2 * static_cast<std::size_t>(i));
  }
}

Content ReadChunks(const Bytes& bytes)
{
  Content content;
  bool headed = false;
  for (std::size_t at = 8;;)
  {
    const std::uint32_t length = bytes.Big32(at);
    const Bytes named = bytes.Part(at + 4, static_cast<std::size_t>(length) + 4);
    const std::uint32_t sum = bytes.Big32(at + 8 + length);
    at += static_cast<std::size_t>(length) + 12;
    if (sum != crc32(crc32(0, nullptr, 0), named.Data(), static_cast<uInt>(named.Size())))
    {
      throw Failure("it is damaged");
    }
    const std::string name(named.Data(), named.Data() + 4);
    const Bytes chunk = named.From(4);
    if (headed == (name == "IHDR"))
    {
      throw Failure(headed ? "it has two headers" : "it lacks its header");
    }
    if (name == "IHDR")
    {
      content.Head = ReadPNGHeader(chunk);
      headed = true;
    }
    else if (name == "PLTE")
    {
      if (chunk.Size() % 3 != 0 || chunk.Size() == 0 || chunk.Size() > 3 * 256)
      {
        throw Failure("its palette is damaged");
      }
      content.Colors.clear();
      for (std::size_t i = 0; i < chunk.Size(); i += 3)
      {
        content.Colors.push_back({ chunk[i], chunk[i + 1], chunk[i + 2], 255 });
      }
    }
    else if (name == "tRNS")
    {
      ReadTransparency(chunk, content);
    }
    else if (name == "IDAT")
    {
      content.Parts.push_back(chunk);
    }
    else if (name == "IEND")
    {
      break;
    }
    else if (name[0] >= 'A' && name[0] <= 'Z')
    {
      throw Failure("it has a chunk that is needed and not known");
    }
  }
  if (content.Head.Kind == Palette && content.Colors.empty())
  {
    throw Failure("it lacks its palette (PLTE)");
  }
  return content;
}

// Unpacks the parts in order.
class Inflater
{
public:
  explicit Inflater(const std::vector<Bytes>& parts)
    : Parts(parts)
  {
    if (inflateInit(&this->Stream) != Z_OK)
    {
      throw Failure("there is no memory to unpack it");
    }
  }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  void operator=(const Inflater&) = delete;

  void Read(std::vector<unsigned char>& row)
  {
    this->Stream.next_out = row.data();
    this->Stream.avail_out = static_cast<uInt>(row.size());
    while (this->Stream.avail_out > 0)
    {
      while (this->Stream.avail_in == 0)
      {
        if (this->Next == this->Parts.size())
        {
          throw Failure("it has too little data: it ends too early");
        }
        // zlib takes a non-const pointer to unchanged data.
        this->Stream.next_in = const_cast<Bytef*>(this->Parts[this->Next].Data());
        this->Stream.avail_in = static_cast<uInt>(this->Parts[this->Next].Size());
        ++this->Next;
      }
      const int done = inflate(&this->Stream, Z_NO_FLUSH);
      if (done == Z_STREAM_END && this->Stream.avail_out > 0)
      {
        throw Failure("it has too little data: it ends too early");
      }
      if (done != Z_OK && done != Z_STREAM_END)
      {
        throw Failure("its data are damaged");
      }
    }
  }

private:
  const std::vector<Bytes>& Parts;
  std::size_t Next = 0;
  z_stream Stream{};
};

int Paeth(int left, int above, int corner)
{
  const int guess = left + above - corner;
  const int toLeft = std::abs(guess - left);
  const int toAbove = std::abs(guess - above);
  const int toCorner = std::abs(guess - corner);
  return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
}

// Rows begin with their filter's number; `pixel` is the distance in bytes to the sample to the
// left.
void Unfilter(std::vector<unsigned char>& row, const std::vector<unsigned char>& above, int pixel)
{
  const int filter = row[0];
  if (filter > 4)
  {
    throw Failure("its data are damaged");
  }
  for (std::size_t i = 1; filter != 0 && i < row.size(); ++i)
  {
    const bool first = i <= static_cast<std::size_t>(pixel);
    const int left = first ? 0 : row[i - pixel];
    const int corner = first ? 0 : above[i - pixel];
    const int guess = filter == 1 ? left
      : filter == 2               ? above[i]
      : filter == 3               ? (left + above[i]) / 2
                                  : Paeth(left, above[i], corner);
    row[i] = static_cast<unsigned char>(row[i] + guess);
  }
}

unsigned int SampleOf(const unsigned char* samples, std::size_t at, int depth)
{
  if (depth == 16)
  {
    return (samples[2 * at] << 8) | samples[2 * at + 1];
  }
  if (depth == 8)
  {
    return samples[at];
  }
  const std::size_t bit = at * depth;
  return (samples[bit / 8] >> (8 - depth - bit % 8)) & ((1U << depth) - 1);
}

// Puts a row of the file, or of one of its interlaced pictures, to every `step`-th texel from `to`.
template <typename T>
void PutRow(const Content& content, const unsigned char* samples, std::uint32_t width, T* to,
  std::size_t step)
{
  const PNGHeader& head = content.Head;
  const unsigned int most = (1U << head.Depth) - 1;
  for (std::uint32_t x = 0; x < width; ++x, to += step)
  {
    if (head.Kind == Palette)
    {
      const unsigned int index = SampleOf(samples, x, head.Depth);
      if (index >= content.Colors.size())
      {
        throw Failure("it has colours that are not in its palette");
      }
      std::copy_n(content.Colors[index].begin(), content.Alpha.There ? 4 : 3, to);
      continue;
    }
    bool key = content.Alpha.There && head.Samples != 2 && head.Samples != 4;
    const bool adds = key;
    for (int c = 0; c < head.Samples; ++c)
    {
      const unsigned int sample =
        SampleOf(samples, static_cast<std::size_t>(x) * head.Samples + c, head.Depth);
      to[c] = static_cast<T>(head.Depth < 8 ? sample * 255 / most : sample);
      key = key && sample == content.Alpha.Key[c];
    }
    if (adds)
    {
      to[head.Samples] = static_cast<T>(key ? 0 : head.Depth == 16 ? 65535 : 255);
    }
  }
}

struct Pass
{
  std::uint32_t X, Y, StepX, StepY;
};

template <typename T>
void PutRows(const Content& content, vtkImageData* image)
{
  const PNGHeader& head = content.Head;
  const std::vector<Pass> passes = head.Interlaced ? std::vector<Pass>{ { 0, 0, 8, 8 },
    { 4, 0, 8, 8 }, { 0, 4, 4, 8 }, { 2, 0, 4, 4 }, { 0, 2, 2, 4 }, { 1, 0, 2, 2 }, { 0, 1, 1, 2 } }
                                                   : std::vector<Pass>{ { 0, 0, 1, 1 } };
  const int bits = head.Depth * head.Samples;
  const auto components = static_cast<std::size_t>(image->GetNumberOfScalarComponents());
  Inflater inflater(content.Parts);
  for (const Pass& pass : passes)
  {
    if (pass.X >= head.Width || pass.Y >= head.Height)
    {
      continue;
    }
    const std::uint32_t width = (head.Width - pass.X + pass.StepX - 1) / pass.StepX;
    const std::size_t length = 1 + (static_cast<std::size_t>(width) * bits + 7) / 8;
    std::vector<unsigned char> row(length);
    std::vector<unsigned char> above(length, 0);
    for (std::uint32_t y = pass.Y; y < head.Height; y += pass.StepY)
    {
      inflater.Read(row);
      Unfilter(row, above, std::max(1, bits / 8));
      PutRow(content, row.data() + 1, width,
        Row<T>(image, head.Height - 1 - y) + components * pass.X, components * pass.StepX);
      row.swap(above);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodePNG(const Bytes& bytes)
{
  const Content content = ReadChunks(bytes);
  const PNGHeader& head = content.Head;
  // Before memory is allocated: deflate packs data to no less than 1/1032 of their size.
  std::uint64_t packed = 0;
  for (const Bytes& part : content.Parts)
  {
    packed += part.Size();
  }
  const std::uint64_t rowBits = static_cast<std::uint64_t>(head.Width) * head.Depth * head.Samples;
  if (rowBits / 8 * head.Height > 1032 * packed)
  {
    throw Failure("it has too little data: it ends too early");
  }
  const int own = head.Kind == Palette ? 3 : head.Samples;
  const bool adds = content.Alpha.There && own % 2 == 1;
  auto image = MakeImage(head.Width, head.Height,
    head.Depth == 16 ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR, own + (adds ? 1 : 0));
  if (head.Depth == 16)
  {
    PutRows<unsigned short>(content, image);
  }
  else
  {
    PutRows<unsigned char>(content, image);
  }
  return image;
}
}
