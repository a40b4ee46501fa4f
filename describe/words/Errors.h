// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The ways in which the work on a scene ends badly. They are thrown where the trouble is met and
 * caught once, by vtkRelievoScene or a program.
 */
#ifndef Errors_h
#define Errors_h

#include <stdexcept>

namespace scene
{
/// The words were wrong: exit status 2. The text names the option, what was given, what was
/// expected.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The work failed: exit status 1.
struct WorkError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written, which the text names.
struct FileError : WorkError
{
  using WorkError::WorkError;
};
}

#endif
