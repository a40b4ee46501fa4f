// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Truevision TGA: the types 1, 2, 3 and their run-length forms 9, 10, 11, of 8, 15, 16, 24 and 32
// bits (Truevision, TGA File Format Specification, version 2.0). Alpha is taken from the attribute
// bits in the descriptor; without any, 32-bit images are opaque.
#include "vtkRelievoImageBytes.h"

#include <algorithm>
#include <array>
#include <vector>

namespace relievo::image
{
namespace
{
using Texel = std::array<unsigned char, 4>;

struct TGAHeader
{
  int Type = 0; // without its run-length bit: 1 palette, 2 colours, 3 grey
  bool Runs = false;
  std::uint32_t FirstColor = 0;
  std::uint32_t Colors = 0;
  int ColorBits = 0;
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  int Bits = 0;
  bool Alpha = false;
  bool FromRight = false;
  bool FromTop = false;
  std::size_t Data = 0; // offset of the data after the header and its text
};

bool IsColor(int bits)
{
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

TGAHeader ReadTGAHeader(const Bytes& bytes)
{
  TGAHeader head;
  head.Type = bytes[2] & ~8;
  head.Runs = (bytes[2] & 8) != 0;
  head.FirstColor = bytes.Little16(3);
  head.Colors = bytes[1] == 1 ? bytes.Little16(5) : 0;
  head.ColorBits = bytes[7];
  head.Width = bytes.Little16(12);
  head.Height = bytes.Little16(14);
  head.Bits = bytes[16];
  head.Alpha = (bytes[17] & 15) != 0;
  head.FromRight = (bytes[17] & 16) != 0;
  head.FromTop = (bytes[17] & 32) != 0;
  head.Data = 18 + static_cast<std::size_t>(bytes[0]);
  const bool known = head.Type == 1 ? head.Bits == 8 && head.Colors > 0 && IsColor(head.ColorBits)
                                    : (head.Type == 2 && IsColor(head.Bits)) ||
      (head.Type == 3 && head.Bits == 8) || (head.Type == 3 && head.Bits == 16);
  if (!known || bytes[1] > 1 || (bytes[17] & 0xC0) != 0)
  {
    throw Failure("it is a kind of TGA that is not read (type " + std::to_string(bytes[2]) + ", " +
      std::to_string(head.Bits) + " bits)");
  }
  return head;
}

Texel ColorOf(const Bytes& bytes, int bits, bool alpha)
{
  if (bits >= 24)
  {
    return { bytes[2], bytes[1], bytes[0],
      bits == 32 && alpha ? bytes[3] : static_cast<unsigned char>(255) };
  }
  const std::uint32_t word = bytes.Little16(0);
  const auto five = [word](int shift) {
    return static_cast<unsigned char>((((word >> shift) & 31) * 255 + 15) / 31);
  };
  const bool seen = bits != 16 || !alpha || (word >> 15) != 0;
  return { five(10), five(5), five(0), static_cast<unsigned char>(seen ? 255 : 0) };
}

// Texels in the file's order.
class Texels
{
public:
  Texels(const TGAHeader& head, const Bytes& bytes)
    : Head(head)
    , Rest(bytes.From(head.Data))
    , Size(static_cast<std::size_t>(head.Bits + 7) / 8)
  {
    if (head.Colors > 0)
    {
      const std::size_t each = static_cast<std::size_t>(head.ColorBits + 7) / 8;
      const Bytes table = this->Take(each * head.Colors);
      for (std::size_t i = 0; i < head.Colors && head.Type == 1; ++i)
      {
        this->Palette.push_back(ColorOf(table.From(i * each), head.ColorBits, head.Alpha));
      }
    }
  }

  Texel Next()
  {
    if (this->Head.Runs && this->Left == 0)
    {
      const unsigned char packet = this->Take(1)[0];
      this->Left = (packet & 127) + 1;
      this->Repeats = (packet & 128) != 0;
      if (this->Repeats)
      {
        this->Last = this->Read();
      }
    }
    this->Left = std::max(0, this->Left - 1);
    return this->Head.Runs && this->Repeats ? this->Last : this->Read();
  }

private:
  Bytes Take(std::size_t size)
  {
    const Bytes taken = this->Rest.Part(0, size);
    this->Rest = this->Rest.From(size);
    return taken;
  }
  Texel Read()
  {
    const Bytes bytes = this->Take(this->Size);
    if (this->Head.Type == 2)
    {
      return ColorOf(bytes, this->Head.Bits, this->Head.Alpha);
    }
    if (this->Head.Type == 3)
    {
      const unsigned char alpha = this->Head.Bits == 16 ? bytes[1] : 255;
      return { bytes[0], alpha, 0, 0 };
    }
    const std::size_t index = bytes[0];
    if (index < this->Head.FirstColor || index - this->Head.FirstColor >= this->Palette.size())
    {
      throw Failure("it has colours that are not in its palette");
    }
    return this->Palette[index - this->Head.FirstColor];
  }

  const TGAHeader& Head;
  Bytes Rest;
  std::size_t Size;
  std::vector<Texel> Palette;
  int Left = 0; // of a packet
  bool Repeats = false;
  Texel Last{};
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeTGA(const Bytes& bytes)
{
  const TGAHeader head = ReadTGAHeader(bytes);
  const int bits = head.Type == 1 ? head.ColorBits : head.Bits;
  const bool alpha = head.Alpha && (bits == 32 || bits == 16);
  const int components = head.Type == 3 ? (head.Bits == 16 ? 2 : 1) : alpha ? 4 : 3;
  CheckSize(head.Width, head.Height, components, 1);
  // Before memory is allocated: a packet of at least 2 bytes makes at most 128 texels.
  const std::uint64_t texels = static_cast<std::uint64_t>(head.Width) * head.Height;
  if (bytes.Size() < (head.Runs ? texels / 128 : texels))
  {
    ThrowCut();
  }
  auto image = MakeImage(head.Width, head.Height, VTK_UNSIGNED_CHAR, components);
  Texels next(head, bytes);
  for (std::uint32_t y = 0; y < head.Height; ++y)
  {
    auto* row = Row<unsigned char>(image, head.FromTop ? head.Height - 1 - y : y);
    for (std::uint32_t x = 0; x < head.Width; ++x)
    {
      const Texel texel = next.Next();
      std::copy_n(texel.begin(), components,
        row + static_cast<std::size_t>(head.FromRight ? head.Width - 1 - x : x) * components);
    }
  }
  return image;
}
}
