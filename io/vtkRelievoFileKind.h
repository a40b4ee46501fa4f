// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a path is a file that can be opened without waiting for somebody to write into it. Asked
// by all that opens a path which a file or a user names.
#ifndef vtkRelievoFileKind_h
#define vtkRelievoFileKind_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace vtkRelievoFileKind
{
// What is there instead of a file, to follow "expected a file, but": "it is a folder", "it is a
// pipe". Empty for a regular file or a link to one, and where nothing is, which opening it tells.
VTKRELIEVOIO_EXPORT std::string FindInstead(const std::string& path);

// Reads a file of at most so many bytes. Returns "", or what is wrong with it.
VTKRELIEVOIO_EXPORT std::string ReadWhole(
  const std::string& path, std::size_t most, std::string& bytes);
}

#endif
