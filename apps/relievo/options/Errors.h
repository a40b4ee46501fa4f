// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The two ways in which the command ends badly. They are thrown where the trouble is met and caught
 * once, in main(), which prints the text and turns the kind into the exit status.
 */
#ifndef Errors_h
#define Errors_h

#include <stdexcept>

namespace cli
{
/// The command line was wrong: exit status 2. The text names the option, what was given, what was
/// expected.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The work failed: exit status 1. The text names the file.
struct WorkError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
}

#endif
