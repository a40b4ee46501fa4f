// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Errors.h"
#include "Values.h"

#include <algorithm>

namespace scene
{
//------------------------------------------------------------------------------
void ParseArguments(const std::vector<std::string>& words, const std::string& command,
  const std::vector<KnownOption>& known,
  const std::function<void(const std::string& name, const std::string& value)>& option,
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
    const auto row = std::find_if(known.begin(), known.end(),
      [&name](const KnownOption& candidate) { return candidate.Name == name; });
    if (row == known.end())
    {
      std::vector<std::string> names;
      for (const KnownOption& one : known)
      {
        names.push_back(one.Name);
      }
      throw UsageError(
        name + ": relievo " + command + " has no such option; it has " + Join(names, ", "));
    }
    if (row->IsFlag)
    {
      if (equals != std::string::npos)
      {
        throw UsageError(word + ": " + name + " takes no value");
      }
      option(name, "");
    }
    else if (equals != std::string::npos)
    {
      option(name, word.substr(equals + 1));
    }
    else if (i + 1 < words.size() && words[i + 1].rfind("--", 0) != 0)
    {
      option(name, words[++i]);
    }
    else
    {
      throw UsageError(name + ": its value is missing; see relievo --help");
    }
  }
}
}
