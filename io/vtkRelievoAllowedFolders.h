// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which files a file may name: a file of somebody else must not show what else the user's disk
// holds. Asked by all that opens a path which a file names, such as a texture, a buffer or a piece.
#ifndef vtkRelievoAllowedFolders_h
#define vtkRelievoAllowedFolders_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <filesystem>
#include <string>
#include <vector>

class VTKRELIEVOIO_EXPORT vtkRelievoAllowedFolders
{
public:
  // The folder of the file that the user names, and others that the user allows, each with what is
  // below it.
  vtkRelievoAllowedFolders(const std::string& file, const std::vector<std::string>& others);

  // Why the path is not opened: with its links resolved it lies elsewhere, be there something or
  // not. Empty in one of the folders.
  std::string FindObstacle(const std::string& path) const;

private:
  std::vector<std::filesystem::path> Folders;
};

#endif
