// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Restricts the files that a file may name: files from others must not reveal other content of the
// user's disk. Used wherever a path named in a file is opened, such as a texture, a buffer or a
// piece.
#ifndef vtkRelievoAllowedFolders_h
#define vtkRelievoAllowedFolders_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <filesystem>
#include <string>
#include <vector>

class VTKRELIEVOIO_EXPORT vtkRelievoAllowedFolders
{
public:
  // The folder of the file that the user names, and further folders that the user allows, each
  // including its subfolders.
  vtkRelievoAllowedFolders(const std::string& file, const std::vector<std::string>& others);

  // Why the path is not opened: with links resolved, it lies elsewhere, whether or not it exists.
  // Empty if it lies in one of the folders.
  std::string FindObstacle(const std::string& path) const;

private:
  std::vector<std::filesystem::path> Folders;
};

#endif
