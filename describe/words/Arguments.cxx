// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Errors.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace words
{
namespace
{
// Letters to insert, remove or replace, to make one word from the other (Levenshtein 1966).
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({ diagonal + (a[i] != b[j]), above + 1, row[j] + 1 });
      diagonal = above;
    }
  }
  return row.back();
}

// All options of a command that has few.
std::string ListAll(const vtkRelievoCommand& command)
{
  std::string names;
  for (const vtkRelievoOption& option : command.Options)
  {
    names += (names.empty() ? "; it has " : ", ") + option.Name;
  }
  return names;
}

// Three of the command's options at most that may be meant by this word, and where all are.
std::string ListSimilar(const std::string& word, const vtkRelievoCommand& command)
{
  std::multimap<std::size_t, std::string> similar;
  for (const vtkRelievoOption& option : command.Options)
  {
    const std::size_t distance = EditDistance(word, option.Name);
    if (distance <= std::max<std::size_t>(2, word.size() / 3))
    {
      similar.emplace(distance, option.Name);
    }
  }
  std::string names;
  std::size_t count = 0;
  for (auto it = similar.begin(); it != similar.end() && count < 3; ++it, ++count)
  {
    names += (names.empty() ? "; did you mean " : " or ") + it->second;
  }
  return names + (names.empty() ? "." : "?") + " See relievo " + command.Name + " --help";
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
      constexpr std::size_t few = 20;
      throw UsageError(name + ": relievo " + command.Name + " has no such option" +
        (command.Options.size() <= few ? ListAll(command) : ListSimilar(name, command)));
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
GivenWords TakeArguments(const std::vector<std::string>& words, const vtkRelievoCommand& command,
  const std::function<void(const std::string& word)>& plain)
{
  GivenWords given;
  SplitArguments(
    words, command,
    [&given](const vtkRelievoOption& row, const std::string& value) {
      if (!given.insert_or_assign(row.Name, value).second && !row.Repeats)
      {
        throw UsageError(row.Name + ": given twice, expected once");
      }
      if (value.empty() && !row.IsFlag())
      {
        throw UsageError(row.Name + ": its value is empty; see relievo --help");
      }
      const std::string error = row.Take(value);
      if (!error.empty())
      {
        throw UsageError(row.Name + ": " + error);
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
