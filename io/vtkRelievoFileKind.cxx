// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFileKind.h"

#include <filesystem>
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
