// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Errors.h"

#include <algorithm>

namespace words
{
namespace
{
std::string ListNames(const vtkRelievoCommand& command)
{
  std::string names;
  for (const vtkRelievoOption& option : command.Options)
  {
    names += (names.empty() ? "" : ", ") + option.Name;
  }
  return names;
}
}

//------------------------------------------------------------------------------
void SplitArguments(const std::vector<std::string>& words, const vtkRelievoCommand& command,
  const std::function<void(const vtkRelievoOption& row, const std::string& value)>& option,
  const std::function<void(const std::string& word)>& plain)
{
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::string& word = words[i];
    if (word == "--")
    {
      std::for_each(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end(), plain);
      return;
    }
    if (word.size() < 2 || word[0] != '-')
    {
      plain(word);
      continue;
    }
    const std::string::size_type equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const vtkRelievoOption* row = command.Find(name);
    if (!row)
    {
      throw UsageError(
        name + ": relievo " + command.Name + " has no such option; it has " + ListNames(command));
    }
    if (row->IsFlag())
    {
      if (equals != std::string::npos)
      {
        throw UsageError(word + ": " + name + " takes no value");
      }
      option(*row, "");
    }
    else if (equals != std::string::npos)
    {
      option(*row, word.substr(equals + 1));
    }
    else if (i + 1 < words.size() && words[i + 1].rfind("--", 0) != 0)
    {
      option(*row, words[++i]);
    }
    else
    {
      throw UsageError(name + ": its value is missing; see relievo --help");
    }
  }
}

//------------------------------------------------------------------------------
std::set<std::string> TakeArguments(const std::vector<std::string>& words,
  const vtkRelievoCommand& command, const std::function<void(const std::string& word)>& plain)
{
  std::set<std::string> given;
  SplitArguments(
    words, command,
    [&given](const vtkRelievoOption& row, const std::string& value) {
      if (!given.insert(row.Name).second && !row.Repeats)
      {
        throw UsageError(row.Name + ": given twice, expected once");
      }
      if (value.empty() && !row.IsFlag())
      {
        throw UsageError(row.Name + ": its value is empty; see relievo --help");
      }
      const std::string wrong = row.Take(value);
      if (!wrong.empty())
      {
        throw UsageError(row.Name + ": " + wrong);
      }
    },
    plain);
  for (const vtkRelievoOption& option : command.Options)
  {
    if (!option.Missing.empty() && given.count(option.Name) == 0)
    {
      throw UsageError(command.Name + ": " + option.Missing);
    }
  }
  return given;
}
}
