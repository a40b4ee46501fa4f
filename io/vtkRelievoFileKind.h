// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a path is a file that can be opened without waiting for a writer. Used wherever a path
// named by a file or a user is opened.
#ifndef vtkRelievoFileKind_h
#define vtkRelievoFileKind_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace vtkRelievoFileKind
{
// The kind of a path that is not a file, to follow "expected a file, but": "it is a folder", "it is
// a pipe". Empty for a regular file or a link to one, and for a missing file, which opening
// reports.
VTKRELIEVOIO_EXPORT std::string FindInstead(const std::string& path);

// Reads a file of at most so many bytes. Returns "", or the problem.
VTKRELIEVOIO_EXPORT std::string ReadWhole(
  const std::string& path, std::size_t most, std::string& bytes);
}

#endif
