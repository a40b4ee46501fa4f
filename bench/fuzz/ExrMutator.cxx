// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExrMutator.h"

#include <algorithm>
#include <cstring>

namespace exrFuzz
{
namespace
{
// No std distributions: their results differ between standard libraries.
uint64_t Below(std::mt19937_64& random, uint64_t limit)
{
  return limit == 0 ? 0 : random() % limit;
}

uint32_t InterestingInt(std::mt19937_64& random)
{
  const uint32_t values[] = { 0, 1, 2, 3, 4, 7, 8, 15, 16, 17, 31, 32, 64, 255, 256, 1000, 4096,
    65535, 65536, 1u << 20, 1u << 24, 1u << 28, 1u << 30, 0x3fffffff, 0x7ffffffe, 0x7fffffff,
    0x80000000, 0x80000001, 0xfffffff0, 0xfffffffe, 0xffffffff };
  return Below(random, 4) == 0 ? static_cast<uint32_t>(random())
                               : values[Below(random, sizeof(values) / sizeof(values[0]))];
}

void PutInt(std::string& bytes, std::size_t at, uint32_t value)
{
  for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
  {
    bytes[at + i] = static_cast<char>(value >> (8 * i));
  }
}

uint32_t GetInt(const std::string& bytes, std::size_t at)
{
  uint32_t value = 0;
  for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
  {
    value |= static_cast<uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

struct AttributePlace
{
  std::size_t Type;
  std::size_t Size;
  std::size_t Value;
  std::size_t End;
};

// The positions of the first header's attributes, as far as they can be parsed; `end` is after the
// header.
std::vector<AttributePlace> FindAttributes(const std::string& bytes, std::size_t& end)
{
  std::vector<AttributePlace> places;
  std::size_t at = 8;
  while (at < bytes.size() && bytes[at] != 0)
  {
    AttributePlace place;
    place.Type = bytes.find('\0', at) + 1;
    place.Size = place.Type == 0 ? 0 : bytes.find('\0', place.Type) + 1;
    if (place.Type == 0 || place.Size == 0 || place.Size + 4 > bytes.size())
    {
      break;
    }
    place.Value = place.Size + 4;
    place.End = place.Value + GetInt(bytes, place.Size);
    if (place.End > bytes.size())
    {
      break;
    }
    places.push_back(place);
    at = place.End;
  }
  end = std::min(at + 1, bytes.size());
  return places;
}
}

//------------------------------------------------------------------------------
Mutator::Mutator(std::vector<std::string> seeds)
  : Seeds(std::move(seeds))
{
}

//------------------------------------------------------------------------------
std::string Mutator::Make(uint64_t index) const
{
  Random random(index * 0x9e3779b97f4a7c15u + 1);
  std::string bytes = this->Seeds[Below(random, this->Seeds.size())];
  // A third of the files have damaged headers; in most others the header is intact, so that the
  // damage reaches the decompression of pixels.
  const bool header = Below(random, 3) == 0;
  const bool anywhere = Below(random, 4) == 0;
  const uint64_t count = 1 + Below(random, 4);
  for (uint64_t i = 0; i < count && !bytes.empty(); ++i)
  {
    std::size_t end = 0;
    FindAttributes(bytes, end);
    if (header)
    {
      this->DamageHeader(bytes, random);
    }
    else
    {
      this->Damage(bytes, anywhere || end >= bytes.size() ? 0 : end, random);
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void Mutator::Damage(std::string& bytes, std::size_t from, Random& random) const
{
  const std::size_t at = from + Below(random, bytes.size() - from);
  const std::size_t length = Below(random, std::min<std::size_t>(64, bytes.size() - at)) + 1;
  switch (Below(random, 12))
  {
    case 0:
    case 1:
    case 2: // bits
      for (uint64_t i = Below(random, 16) + 1; i > 0; --i)
      {
        bytes[from + Below(random, bytes.size() - from)] ^=
          static_cast<char>(1 << Below(random, 8));
      }
      break;
    case 3:
    case 4:
    case 5: // bytes
      for (std::size_t i = at; i < at + length; ++i)
      {
        const char values[] = { 0, 1, 127, -128, -1, static_cast<char>(random()) };
        bytes[i] = values[Below(random, 6)];
      }
      break;
    case 6: // an integer
      PutInt(bytes, at, InterestingInt(random));
      break;
    case 7: // cut off, or lengthened
      if (Below(random, 4) == 0)
      {
        bytes.append(Below(random, 100), static_cast<char>(random()));
      }
      else
      {
        bytes.resize(at);
      }
      break;
    case 8: // a section is missing
      bytes.erase(at, length);
      break;
    case 9: // a section is repeated
      bytes.insert(at, bytes.substr(at, length));
      break;
    case 10: // a section, or the rest, of another file
    {
      const std::string& other = this->Seeds[Below(random, this->Seeds.size())];
      const std::size_t begin = Below(random, other.size());
      const std::string stretch =
        other.substr(begin, Below(random, 2) == 0 ? std::string::npos : length);
      bytes = Below(random, 2) == 0 ? bytes.substr(0, at) + stretch
                                    : bytes.replace(at, stretch.size(), stretch);
      break;
    }
    default: // two sections are swapped
    {
      const std::size_t other = from + Below(random, bytes.size() - from);
      for (std::size_t i = 0; i < length && at + i < bytes.size() && other + i < bytes.size(); ++i)
      {
        std::swap(bytes[at + i], bytes[other + i]);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Mutator::DamageHeader(std::string& bytes, Random& random) const
{
  std::size_t end = 0;
  const std::vector<AttributePlace> places = FindAttributes(bytes, end);
  if (bytes.size() < 16 || places.empty())
  {
    return this->Damage(bytes, 0, random);
  }
  const AttributePlace place = places[Below(random, places.size())];
  const std::size_t size = place.End - place.Value;
  switch (Below(random, 8))
  {
    case 0: // another size, the value unchanged
      PutInt(bytes, place.Size, InterestingInt(random));
      break;
    case 1: // another type
    {
      const AttributePlace other = places[Below(random, places.size())];
      const std::string type = bytes.substr(other.Type, other.Size - other.Type);
      bytes.replace(place.Type, place.Size - place.Type, type);
      break;
    }
    case 2: // another value, of integers or bytes
    case 3:
      if (size >= 4 && Below(random, 3) != 0)
      {
        PutInt(bytes, place.Value + 4 * Below(random, size / 4), InterestingInt(random));
      }
      else if (size > 0)
      {
        bytes[place.Value + Below(random, size)] =
          static_cast<char>(Below(random, 3) == 0 ? random() : Below(random, 12));
      }
      break;
    case 4: // removed, or repeated
      if (Below(random, 2) == 0)
      {
        const std::size_t name = place.Type - 1 - std::strlen(&bytes[8]);
        bytes.erase(std::max<std::size_t>(8, name), place.End - std::max<std::size_t>(8, name));
      }
      else
      {
        bytes.insert(place.End, bytes.substr(8, place.End - 8));
      }
      break;
    case 5: // a longer or shorter value, with the right size
    {
      const std::size_t longer = Below(random, 40);
      const bool grow = Below(random, 2) == 0;
      const std::size_t cut = std::min(size, longer);
      PutInt(bytes, place.Size, static_cast<uint32_t>(grow ? size + longer : size - cut));
      grow ? bytes.insert(place.End, longer, static_cast<char>(random()))
           : bytes.erase(place.End - cut, cut);
      break;
    }
    case 6: // the flags
      bytes[5] =
        static_cast<char>(Below(random, 2) == 0 ? random() : bytes[5] ^ (1 << Below(random, 6)));
      break;
    default: // an offset of a chunk, or the data before its pixels
      PutInt(bytes, end + 4 * Below(random, 40), InterestingInt(random));
  }
}
}
