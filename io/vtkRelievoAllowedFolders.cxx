// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAllowedFolders.h"

#include <algorithm>
#include <system_error>

namespace
{
bool IsBelow(const std::filesystem::path& path, const std::filesystem::path& folder)
{
  const auto ends = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return ends.first == folder.end();
}
}

//------------------------------------------------------------------------------
vtkRelievoAllowedFolders::vtkRelievoAllowedFolders(
  const std::string& file, const std::vector<std::string>& others)
{
  std::vector<std::filesystem::path> named = { std::filesystem::path(file).parent_path() };
  named.insert(named.end(), others.begin(), others.end());
  for (const std::filesystem::path& folder : named)
  {
    std::error_code trouble;
    const std::filesystem::path whole =
      std::filesystem::canonical(folder.empty() ? "." : folder, trouble);
    if (!trouble)
    {
      this->Folders.push_back(whole);
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoAllowedFolders::FindObstacle(const std::string& path) const
{
  std::error_code trouble;
  std::filesystem::path whole = std::filesystem::absolute(path, trouble);
  if (!trouble)
  {
    whole = std::filesystem::weakly_canonical(whole, trouble);
  }
  if (trouble)
  {
    return trouble.message();
  }
  const bool isAllowed = std::any_of(this->Folders.begin(), this->Folders.end(),
    [&whole](const std::filesystem::path& folder) { return IsBelow(whole, folder); });
  return isAllowed ? ""
                   : "it lies outside the folder of the file that names it; to read it, allow " +
      whole.parent_path().string() + " (--allow-folder)";
}
