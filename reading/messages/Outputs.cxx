// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Errors.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <utility>

#include <unistd.h>

namespace fs = std::filesystem;

namespace reading
{
namespace
{
// The target of a file name, at the end of links, which may not exist yet.
fs::path Follow(const std::string& path, std::error_code& trouble)
{
  constexpr int most = 40; // limit of links, as in Linux
  fs::path place = fs::weakly_canonical(fs::absolute(path), trouble);
  std::error_code none; // the name may not exist
  for (int i = 0; i < most && !trouble && fs::is_symlink(fs::symlink_status(place, none)); ++i)
  {
    const fs::path target = fs::read_symlink(place, trouble);
    place = fs::weakly_canonical(place.parent_path() / target, trouble);
  }
  return place;
}

bool Same(const fs::path& a, const fs::path& b)
{
  std::error_code ignored;
  return a == b || fs::equivalent(a, b, ignored);
}
}

//------------------------------------------------------------------------------
void Outputs::Add(
  const std::string& option, const std::string& path, const std::vector<std::string>& inputs)
{
  std::error_code trouble;
  const std::string named = option + " " + path + ": ";
  const fs::path place = Follow(path, trouble);
  if (trouble)
  {
    throw WorkError(named + trouble.message());
  }
  const fs::path folder = place.parent_path();
  if (!fs::is_directory(folder, trouble))
  {
    throw WorkError(named + "there is no folder " + folder.string());
  }
  const fs::file_status status = fs::status(place, trouble);
  if (fs::is_directory(status) || !place.has_filename())
  {
    throw WorkError(named + "is a folder; give the name of a file");
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw WorkError(named + "is not a regular file, so it cannot be replaced by one");
  }
  const long longest = pathconf(folder.c_str(), _PC_NAME_MAX);
  if (longest > 0 && place.filename().string().size() > static_cast<std::size_t>(longest))
  {
    throw WorkError(named + "the name is too long: a file's may have " + std::to_string(longest) +
      " bytes in folder " + folder.string());
  }
  for (const std::string& input : inputs)
  {
    if (Same(place, fs::weakly_canonical(fs::absolute(input), trouble)))
    {
      throw UsageError(named + "is also a FILE to read; give another name");
    }
  }
  for (const Entry& entry : this->Entries)
  {
    if (Same(place, entry.Place))
    {
      throw UsageError(named + "another option writes the same file; give another name");
    }
  }

  auto file = std::make_unique<vtkRelievoTemporaryFile>(folder.string(), trouble);
  if (trouble)
  {
    throw WorkError(named + "folder " + folder.string() + ": " + trouble.message());
  }
  const std::string temporary = file->GetName();
  this->Entries.push_back({ path, place.string(), temporary, std::move(file), {} });
}

//------------------------------------------------------------------------------
void Outputs::Check(
  const std::string& option, const std::string& path, const std::vector<std::string>& inputs)
{
  std::error_code trouble;
  if (!fs::exists(path, trouble))
  {
    return;
  }
  for (const std::string& input : inputs)
  {
    if (fs::equivalent(path, input, trouble))
    {
      throw UsageError(option + " " + path + ": is read as well, as " +
        fs::path(input).filename().string() + "; give another name");
    }
  }
}

//------------------------------------------------------------------------------
std::string Outputs::Temporary(const std::string& path) const
{
  const auto entry = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&path](const Entry& candidate) { return candidate.Given == path; });
  if (entry == this->Entries.end())
  {
    throw WorkError(path + ": is no output of this run; please report this");
  }
  return entry->Temporary;
}

//------------------------------------------------------------------------------
std::string Outputs::WithGivenNames(std::string text) const
{
  for (const Entry& entry : this->Entries)
  {
    for (std::string::size_type at = text.find(entry.Temporary); at != std::string::npos;
         at = text.find(entry.Temporary, at + entry.Given.size()))
    {
      text.replace(at, entry.Temporary.size(), entry.Given);
    }
  }
  return text;
}

//------------------------------------------------------------------------------
void Outputs::Commit()
{
  // Replaced files keep a second name until all outputs are in place; signals wait meanwhile.
  const vtkRelievoTemporaryFile::Uninterrupted whole;
  std::error_code trouble;
  std::size_t moved = 0;
  for (; moved < this->Entries.size() && !trouble; ++moved)
  {
    Entry& entry = this->Entries[moved];
    std::error_code none; // the old file may not exist
    if (fs::is_regular_file(fs::status(entry.Place, none)))
    {
      // A hard link, so that the place is never empty; where the file system has links.
      entry.Previous = entry.Temporary + ".old";
      fs::create_hard_link(entry.Place, entry.Previous, trouble);
      if (trouble)
      {
        fs::rename(entry.Place, entry.Previous, trouble);
      }
      if (trouble)
      {
        entry.Previous.clear();
        break;
      }
    }
    entry.File->MoveTo(entry.Place, trouble);
    if (trouble)
    {
      break;
    }
  }
  if (!trouble)
  {
    for (const Entry& entry : this->Entries)
    {
      std::error_code none;
      fs::remove(entry.Previous, none);
    }
    return;
  }
  const std::string error = this->Entries[moved].Given + ": " + trouble.message();
  for (std::size_t i = 0; i <= moved; ++i)
  {
    const Entry& entry = this->Entries[i];
    std::error_code none;
    if (!entry.Previous.empty())
    {
      fs::rename(entry.Previous, entry.Place, none);
      if (!none)
      {
        fs::remove(entry.Previous, none); // still there if both names are hard links
      }
    }
    else if (i < moved)
    {
      fs::remove(entry.Place, none);
    }
  }
  throw WorkError(error);
}

//------------------------------------------------------------------------------
void Outputs::RemoveAtEnd()
{
  vtkRelievoTemporaryFile::RemoveAtEnd();
  // A file above its size limit then gives a write error with a message instead of ending the
  // program.
  std::signal(SIGXFSZ, SIG_IGN);
}
}
