// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scripts.h"

namespace viewer
{
namespace
{
std::string Quote(const std::string& word)
{
  constexpr const char* plain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
  {
    return word;
  }
  std::string quoted = "'";
  for (const char letter : word)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}
}

//------------------------------------------------------------------------------
std::string WriteCommand(const Settings& view, const std::string& png)
{
  std::string line = "relievo render --png " + Quote(png);
  for (const std::string& word : view.GetWords())
  {
    line += " " + Quote(word);
  }
  return line;
}
}
