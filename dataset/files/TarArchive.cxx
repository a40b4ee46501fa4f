// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TarArchive.h"

#include "Errors.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace dataset
{
namespace
{
constexpr std::size_t Block = 512;
constexpr std::size_t End = 2 * Block; // zeros
}

//------------------------------------------------------------------------------
void TarArchive::Add(const std::string& name, const std::string& bytes)
{
  // Fields of the header, from its beginning: places, widths.
  constexpr std::size_t mode = 100, owner = 108, group = 116, size = 124, time = 136, check = 148,
                        type = 156, magic = 257;
  std::string header(Block, '\0');
  const auto put = [&header](std::size_t place, const std::string& text) {
    header.replace(place, text.size(), text);
  };
  const auto octal = [](int digits, unsigned long long value) {
    char text[24];
    std::snprintf(text, sizeof(text), "%0*llo", digits, value);
    return std::string(text);
  };
  put(0, name.substr(0, mode));
  put(mode, octal(7, 0644));
  put(owner, octal(7, 0));
  put(group, octal(7, 0));
  put(size, octal(11, bytes.size()));
  put(time, octal(11, 0));
  put(type, "0");
  put(magic, std::string("ustar\00000", 8));
  put(check, "        "); // counts as spaces
  unsigned long long sum = 0;
  for (const char byte : header)
  {
    sum += static_cast<unsigned char>(byte);
  }
  put(check, octal(6, sum) + std::string("\0 ", 2));
  this->Bytes += header + bytes;
  this->Bytes.resize((this->Bytes.size() + Block - 1) / Block * Block, '\0');
}

//------------------------------------------------------------------------------
std::string TarArchive::Finish() const
{
  return this->Bytes + std::string(End, '\0');
}

//------------------------------------------------------------------------------
std::uint64_t GetJoinedTarBytes(const std::vector<std::uint64_t>& sizes)
{
  std::uint64_t sum = End;
  for (const std::uint64_t size : sizes)
  {
    sum += size - std::min<std::uint64_t>(size, End);
  }
  return sum;
}

//------------------------------------------------------------------------------
void JoinTars(
  const std::vector<std::string>& files, const std::function<void(const std::string&)>& take)
{
  constexpr std::uint64_t most = 1 << 20;
  for (const std::string& file : files)
  {
    std::error_code trouble;
    const std::uint64_t size = std::filesystem::file_size(file, trouble);
    std::ifstream in(file, std::ios::binary);
    std::string bytes;
    for (std::uint64_t left = trouble ? 0 : size - std::min<std::uint64_t>(size, End);
         in && left > 0; left -= bytes.size())
    {
      bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left, most)));
      in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      take(bytes);
    }
    if (trouble || !in)
    {
      throw FileError(file + ": cannot be read");
    }
  }
  take(std::string(End, '\0'));
}
}
