// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenedFiles.h"

#include "vtkRelievoReaderProcess.h"

#include <filesystem>
#include <system_error>

namespace scene
{
namespace
{
thread_local std::vector<std::string>* Listed = nullptr;
}

//------------------------------------------------------------------------------
OpenedFiles::OpenedFiles(std::vector<std::string>& list)
  : Before(Listed)
{
  Listed = &list;
}

//------------------------------------------------------------------------------
OpenedFiles::~OpenedFiles()
{
  Listed = this->Before;
}

//------------------------------------------------------------------------------
void OpenedFiles::Add(const std::string& path)
{
  std::error_code trouble;
  if (Listed && std::filesystem::exists(path, trouble))
  {
    const std::uintmax_t size = std::filesystem::file_size(path, trouble);
    vtkRelievoReaderProcess::Allow(trouble ? 0 : size); // a folder has no size
    const std::filesystem::path whole = std::filesystem::absolute(path, trouble);
    Listed->push_back(trouble ? path : whole.string());
  }
}
}
