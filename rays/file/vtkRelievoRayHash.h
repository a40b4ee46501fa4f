// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hash of 64 bits that finds damaged files and other meshes, at the speed of memory; it is no
// protection against forgery. Any change of a single number of eight bytes changes the hash.
#ifndef vtkRelievoRayHash_h
#define vtkRelievoRayHash_h

#include <cstddef>
#include <cstdint>
#include <cstring>

class vtkRelievoRayHash
{
public:
  static constexpr std::size_t Block = 64; // bytes

  // The bytes are padded with zeros to whole blocks.
  void Add(const void* bytes, std::size_t count)
  {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; count >= Block; count -= Block, at += Block)
    {
      this->AddBlock(at);
    }
    if (count > 0)
    {
      unsigned char last[Block] = {};
      std::memcpy(last, at, count);
      this->AddBlock(last);
    }
  }

  std::uint64_t Get() const
  {
    std::uint64_t hash = 0;
    for (const std::uint64_t lane : this->Lanes)
    {
      hash = Mix(hash, lane);
    }
    return hash ^ (hash >> 29);
  }

private:
  // One to one in each of both numbers.
  static std::uint64_t Mix(std::uint64_t hash, std::uint64_t word)
  {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    return hash ^ (hash >> 32);
  }

  void AddBlock(const unsigned char* bytes)
  {
    std::uint64_t words[Block / 8];
    std::memcpy(words, bytes, Block);
    for (std::size_t i = 0; i < Block / 8; ++i)
    {
      this->Lanes[i] = Mix(this->Lanes[i], words[i]);
    }
  }

  std::uint64_t Lanes[Block / 8] = { 1, 2, 3, 4, 5, 6, 7, 8 };
};

#endif
