// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileHash.h"

#include "vtkRelievoFileKind.h"

#include "vtksys/MD5.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace dataset
{
//------------------------------------------------------------------------------
FileHash::FileHash()
  : State(vtksysMD5_New())
{
  vtksysMD5_Initialize(static_cast<vtksysMD5*>(this->State));
}

//------------------------------------------------------------------------------
FileHash::~FileHash()
{
  vtksysMD5_Delete(static_cast<vtksysMD5*>(this->State));
}

//------------------------------------------------------------------------------
void FileHash::Add(const void* bytes, std::size_t size)
{
  constexpr std::size_t most = std::numeric_limits<int>::max();
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0)
  {
    const std::size_t step = std::min(size, most);
    vtksysMD5_Append(static_cast<vtksysMD5*>(this->State), next, static_cast<int>(step));
    next += step;
    size -= step;
  }
}

//------------------------------------------------------------------------------
std::string FileHash::Finish()
{
  constexpr std::size_t digits = 32;
  std::string text(digits, '0');
  vtksysMD5_FinalizeHex(static_cast<vtksysMD5*>(this->State), text.data());
  return text;
}

//------------------------------------------------------------------------------
std::string FileHash::Of(const std::string& bytes)
{
  FileHash hash;
  hash.Add(bytes.data(), bytes.size());
  return hash.Finish();
}

//------------------------------------------------------------------------------
std::string FileHash::OfFile(const std::string& path)
{
  if (!vtkRelievoFileKind::FindInstead(path).empty()) // a pipe would be waited for
  {
    return "";
  }
  std::ifstream file(path, std::ios::binary);
  FileHash hash;
  constexpr std::size_t step = std::size_t(1) << 20;
  std::vector<char> bytes(step);
  while (file)
  {
    file.read(bytes.data(), static_cast<std::streamsize>(step));
    hash.Add(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.eof() ? hash.Finish() : "";
}
}
