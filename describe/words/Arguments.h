// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The words of a command line, told apart: options with their values, and plain words.
 */
#ifndef Arguments_h
#define Arguments_h

#include "vtkRelievoOption.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace scene
{
/// Calls option(row, value) for "--name value" and "--name=value", option(row, "") for a flag, and
/// plain(word) for the other words and all behind "--". Throws UsageError for an option that the
/// command does not have, a value that is missing, and a flag's value.
void SplitArguments(const std::vector<std::string>& words, const vtkRelievoCommand& command,
  const std::function<void(const vtkRelievoOption& row, const std::string& value)>& option,
  const std::function<void(const std::string& word)>& plain);

/// Has the command's options take their values. Returns the names of those that were given. Throws
/// UsageError also for one that is given twice and does not repeat, for an empty value, for one
/// that an option does not take, and for an option that is missing.
std::set<std::string> TakeArguments(const std::vector<std::string>& words,
  const vtkRelievoCommand& command, const std::function<void(const std::string& word)>& plain);
}

#endif
