// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFileKind.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

//------------------------------------------------------------------------------
std::string vtkRelievoFileKind::FindInstead(const std::string& path)
{
  std::error_code trouble;
  switch (std::filesystem::status(path, trouble).type())
  {
    case std::filesystem::file_type::directory:
      return "it is a folder";
    case std::filesystem::file_type::fifo:
      return "it is a pipe";
    case std::filesystem::file_type::socket:
      return "it is a socket";
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
      return "it is a device";
    default:
      return "";
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoFileKind::ReadWhole(
  const std::string& path, std::size_t most, std::string& bytes)
{
  bytes.clear();
  const std::string instead = FindInstead(path);
  if (!instead.empty())
  {
    return "expected a file, but " + instead;
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return std::strerror(errno);
  }
  // Does not trust the size reported by the file system, which may be wrong.
  char part[1 << 16];
  while (bytes.size() <= most && (file.read(part, sizeof part) || file.gcount() > 0))
  {
    bytes.append(part, static_cast<std::size_t>(file.gcount()));
  }
  if (bytes.size() > most)
  {
    bytes.clear();
    return "it has more than " + std::to_string(most >> 20) + " MiB, expected at most these";
  }
  return file.bad() ? "it cannot be read" : "";
}
