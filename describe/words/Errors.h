// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Errors of the work on a scene. They are thrown at their cause and caught once, by vtkRelievoScene
 * or a program.
 */
#ifndef Errors_h
#define Errors_h

#include <stdexcept>

namespace words
{
/// The words were invalid: exit status 2. The text names the option, the given value and the
/// expected one.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The work failed: exit status 1.
struct WorkError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file, named in the text, could not be read or written.
struct FileError : WorkError
{
  using WorkError::WorkError;
};
}

#endif
