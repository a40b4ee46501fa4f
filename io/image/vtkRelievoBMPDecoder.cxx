// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Windows bitmaps: 1, 4, 8, 16, 24 and 32 bits, run-length coded or not, with bit fields, from the
// bottom up or from the top down (Microsoft, Bitmap Storage). Only bit fields provide alpha.
#include "vtkRelievoImageBytes.h"

#include <algorithm>
#include <array>
#include <vector>

namespace relievo::image
{
namespace
{
enum Packing
{
  Plain = 0,
  Runs8 = 1,
  Runs4 = 2,
  Fields = 3,
  FieldsWithAlpha = 6
};

struct BMPHeader
{
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  bool FromTop = false;
  int Bits = 0;
  std::uint32_t Packed = Plain;
  std::array<std::uint32_t, 4> Masks{}; // of red, green, blue, alpha; 0: none
  std::vector<std::array<unsigned char, 3>> Colors;
  std::size_t Data = 0;
};

BMPHeader ReadBMPHeader(const Bytes& bytes)
{
  BMPHeader head;
  head.Data = bytes.Little32(10);
  const std::uint32_t size = bytes.Little32(14);
  const bool old = size == 12; // the header of OS/2
  if (!old && (size < 40 || size > 1024))
  {
    throw Failure("its header is damaged");
  }
  std::uint32_t colors = 0;
  if (old)
  {
    head.Width = bytes.Little16(18);
    head.Height = bytes.Little16(20);
    head.Bits = static_cast<int>(bytes.Little16(24));
  }
  else
  {
    head.Width = bytes.Little32(18);
    head.Height = bytes.Little32(22);
    head.FromTop = head.Height > 0x7FFFFFFFU;
    head.Height = head.FromTop ? 0U - head.Height : head.Height;
    head.Bits = static_cast<int>(bytes.Little16(28));
    head.Packed = bytes.Little32(30);
    colors = bytes.Little32(46);
  }
  const bool deep = head.Bits == 16 || head.Bits == 32;
  const bool known =
    (head.Packed == Plain &&
      (deep || head.Bits == 1 || head.Bits == 4 || head.Bits == 8 || head.Bits == 24)) ||
    (head.Packed == Runs8 && head.Bits == 8 && !head.FromTop) ||
    (head.Packed == Runs4 && head.Bits == 4 && !head.FromTop) ||
    ((head.Packed == Fields || head.Packed == FieldsWithAlpha) && deep);
  if (!known)
  {
    throw Failure("it is a kind of BMP that is not read (" + std::to_string(head.Bits) +
      " bits, compression " + std::to_string(head.Packed) + ")");
  }
  if (head.Width > 0x7FFFFFFFU)
  {
    throw Failure("its header has a width below 0");
  }
  CheckSize(head.Width, head.Height, 4, 1);
  std::size_t table = 14 + static_cast<std::size_t>(size);
  if (head.Packed == Fields || head.Packed == FieldsWithAlpha)
  {
    // Newer headers contain the masks; after older headers they follow.
    const std::size_t count = head.Packed == FieldsWithAlpha || size >= 56 ? 4 : 3;
    for (std::size_t i = 0; i < count; ++i)
    {
      head.Masks[i] = bytes.Little32(54 + 4 * i);
    }
    table = std::max(table, 54 + 4 * count);
  }
  else if (head.Bits == 16)
  {
    head.Masks = { 0x7C00, 0x03E0, 0x001F, 0 };
  }
  else if (head.Bits == 32)
  {
    head.Masks = { 0xFF0000, 0xFF00, 0xFF, 0 };
  }
  if (head.Bits <= 8)
  {
    const std::uint32_t most = 1U << head.Bits;
    const std::size_t each = old ? 3 : 4;
    colors = colors == 0 ? most : colors;
    if (colors > most)
    {
      throw Failure("its palette is damaged");
    }
    for (std::size_t i = 0; i < colors; ++i)
    {
      const Bytes color = bytes.Part(table + i * each, 3);
      head.Colors.push_back({ color[2], color[1], color[0] });
    }
  }
  return head;
}

unsigned char Field(std::uint32_t word, std::uint32_t mask)
{
  if (mask == 0)
  {
    return 0;
  }
  while ((mask & 1) == 0)
  {
    mask >>= 1;
    word >>= 1;
  }
  return static_cast<unsigned char>(
    (static_cast<std::uint64_t>(word & mask) * 255 + mask / 2) / mask);
}

void PutColor(const BMPHeader& head, std::size_t index, unsigned char* to)
{
  if (index >= head.Colors.size())
  {
    throw Failure("it has colours that are not in its palette");
  }
  std::copy_n(head.Colors[index].begin(), 3, to);
}

void PutPlain(const BMPHeader& head, const Bytes& data, vtkImageData* image)
{
  const int components = image->GetNumberOfScalarComponents();
  const std::size_t stride = (static_cast<std::size_t>(head.Width) * head.Bits + 31) / 32 * 4;
  for (std::uint32_t y = 0; y < head.Height; ++y)
  {
    // Some writers leave out the padding of the last row.
    const Bytes row =
      data.Part(stride * y, (static_cast<std::size_t>(head.Width) * head.Bits + 7) / 8);
    auto* to = Row<unsigned char>(image, head.FromTop ? head.Height - 1 - y : y);
    for (std::size_t x = 0; x < head.Width; ++x, to += components)
    {
      if (head.Bits <= 8)
      {
        const std::size_t bit = x * head.Bits;
        PutColor(head, (row[bit / 8] >> (8 - head.Bits - bit % 8)) & ((1U << head.Bits) - 1), to);
      }
      else if (head.Bits == 24)
      {
        to[0] = row[3 * x + 2];
        to[1] = row[3 * x + 1];
        to[2] = row[3 * x];
      }
      else
      {
        const std::uint32_t word = head.Bits == 16 ? row.Little16(2 * x) : row.Little32(4 * x);
        for (int c = 0; c < components; ++c)
        {
          to[c] = Field(word, head.Masks[c]);
        }
      }
    }
  }
}

// Texels that the runs leave out have the palette's first colour.
void PutRuns(const BMPHeader& head, const Bytes& data, vtkImageData* image)
{
  const std::size_t perByte = 8 / static_cast<std::size_t>(head.Bits);
  for (std::uint32_t y = 0; y < head.Height; ++y)
  {
    auto* to = Row<unsigned char>(image, y);
    for (std::uint32_t x = 0; x < head.Width; ++x)
    {
      PutColor(head, 0, to + 3 * static_cast<std::size_t>(x));
    }
  }
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  const auto put = [&](unsigned char pair, std::size_t place) {
    if (x >= head.Width || y >= head.Height)
    {
      throw Failure("its data are damaged: a run leaves the image");
    }
    const std::size_t index = perByte == 1 ? pair : place % 2 == 0 ? pair >> 4 : pair & 15;
    PutColor(head, index, Row<unsigned char>(image, y) + 3 * x);
    ++x;
  };
  for (std::size_t at = 0;;)
  {
    const unsigned char count = data[at];
    const unsigned char value = data[at + 1];
    at += 2;
    for (std::size_t i = 0; i < count; ++i)
    {
      put(value, i);
    }
    if (count > 0)
    {
      continue;
    }
    if (value == 1) // the end of the image
    {
      return;
    }
    if (value == 0) // the end of the row
    {
      x = 0;
      ++y;
    }
    else if (value == 2) // a step
    {
      x += data[at];
      y += data[at + 1];
      at += 2;
    }
    else // single values, padded to two bytes
    {
      for (std::size_t i = 0; i < value; ++i)
      {
        put(data[at + i / perByte], i);
      }
      at += ((value + perByte - 1) / perByte + 1) / 2 * 2;
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeBMP(const Bytes& bytes)
{
  const BMPHeader head = ReadBMPHeader(bytes);
  const Bytes data = bytes.From(head.Data);
  const bool runs = head.Packed == Runs8 || head.Packed == Runs4;
  // Before memory is allocated: a run of 2 bytes makes at most 255 texels; a step skips more.
  const std::uint64_t rowBytes = static_cast<std::uint64_t>(head.Width) * head.Bits / 8;
  if (!runs && data.Size() < rowBytes * head.Height)
  {
    ThrowCut();
  }
  auto image = MakeImage(head.Width, head.Height, VTK_UNSIGNED_CHAR, head.Masks[3] != 0 ? 4 : 3);
  if (runs)
  {
    PutRuns(head, data, image);
  }
  else
  {
    PutPlain(head, data, image);
  }
  return image;
}
}
