// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReadContext.h"

#include "Messages.h"

#include "vtkRelievoReaderProcess.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace reading
{
namespace
{
void AddOnce(std::vector<std::string>& texts, const std::string& text)
{
  if (!text.empty() && std::find(texts.begin(), texts.end(), text) == texts.end())
  {
    texts.push_back(text);
  }
}
}

//------------------------------------------------------------------------------
ReadContext::ReadContext(Progress& progress, std::vector<std::string> folders)
  : Steps(progress)
  , Folders(std::move(folders))
{
}

//------------------------------------------------------------------------------
ReadContext::~ReadContext()
{
  for (const std::string& note : this->Notes)
  {
    Messages::Note(note);
  }
  for (const std::string& warning : this->Warnings)
  {
    Messages::Warn(warning);
  }
}

//------------------------------------------------------------------------------
vtkRelievoAllowedFolders ReadContext::GetAllowed(const std::string& path) const
{
  return vtkRelievoAllowedFolders(path, this->Folders);
}

//------------------------------------------------------------------------------
void ReadContext::Check(const std::string& subject, bool failed, const std::string& otherwise)
{
  for (const std::string& warning : Messages::TakeWarningsOn(subject))
  {
    this->Warn(warning);
  }
  Messages::Check(subject, failed, otherwise);
}

//------------------------------------------------------------------------------
void ReadContext::Note(const std::string& text)
{
  AddOnce(this->Notes, text);
}

//------------------------------------------------------------------------------
void ReadContext::Warn(const std::string& text)
{
  AddOnce(this->Warnings, text);
}

//------------------------------------------------------------------------------
std::vector<std::string> ReadContext::TakeNotes()
{
  return std::exchange(this->Notes, {});
}

//------------------------------------------------------------------------------
std::vector<std::string> ReadContext::TakeWarnings()
{
  return std::exchange(this->Warnings, {});
}

//------------------------------------------------------------------------------
void ReadContext::AddFile(const std::string& path)
{
  std::error_code trouble;
  if (std::filesystem::exists(path, trouble))
  {
    const std::uintmax_t size = std::filesystem::file_size(path, trouble);
    vtkRelievoReaderProcess::Allow(trouble ? 0 : size); // a folder has no size
    const std::filesystem::path whole = std::filesystem::absolute(path, trouble);
    this->Files.push_back(trouble ? path : whole.string());
  }
}

//------------------------------------------------------------------------------
void ReadContext::DoMeanwhile()
{
  if (const auto work = std::exchange(this->Meanwhile, nullptr))
  {
    work();
  }
}
}
