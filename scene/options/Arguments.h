// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The words of a command line, told apart: options with their values, and plain words.
 */
#ifndef Arguments_h
#define Arguments_h

#include <functional>
#include <string>
#include <vector>

namespace scene
{
struct KnownOption
{
  std::string Name;
  bool IsFlag; ///< stands alone; any other takes one value
  bool Repeats = false;
};

/// Calls option(name, value) for "--name value" and "--name=value", option(name, "") for a flag,
/// and plain(word) for the other words and all behind "--". Throws UsageError for an option of
/// `command` that is not known, a value that is missing, and a flag's value.
void ParseArguments(const std::vector<std::string>& words, const std::string& command,
  const std::vector<KnownOption>& known,
  const std::function<void(const std::string& name, const std::string& value)>& option,
  const std::function<void(const std::string& word)>& plain);
}

#endif
