// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Splits a command line into options with their values, and plain words.
 */
#ifndef Arguments_h
#define Arguments_h

#include "vtkRelievoOption.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace words
{
/// The options on a command line, each with its last value; a flag's is empty.
using GivenWords = std::map<std::string, std::string>;

/// The numbers of options that have no variable of their own.
class GivenNumbers
{
public:
  void Set(const std::string& option, double number) { this->All[option] = number; }

  /// The number of an option, or another if it is not given.
  double Get(const std::string& option, double otherwise) const
  {
    const auto found = this->All.find(option);
    return found == this->All.end() ? otherwise : found->second;
  }

private:
  std::map<std::string, double> All;
};

/// Calls option(row, value) for "--name value" and "--name=value", option(row, "") for a flag, and
/// plain(word) for the other words and everything after "--". Throws UsageError for an unknown
/// option, a missing value, and a flag's value.
void SplitArguments(const std::vector<std::string>& words, const vtkRelievoCommand& command,
  const std::function<void(const vtkRelievoOption& row, const std::string& value)>& option,
  const std::function<void(const std::string& word)>& plain);

/// Passes the values to the command's options. Also throws UsageError for an option that is given
/// twice and does not repeat, for an empty or invalid value, and for a missing required option.
GivenWords TakeArguments(const std::vector<std::string>& words, const vtkRelievoCommand& command,
  const std::function<void(const std::string& word)>& plain);
}

#endif
