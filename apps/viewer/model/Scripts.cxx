// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scripts.h"

#include <QString>

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace viewer
{
namespace
{
// Whether a clipboard and a terminal leave the word as it is.
bool IsPrinted(const std::string& word)
{
  return QString::fromStdString(word).toStdString() == word &&
    std::none_of(word.begin(), word.end(),
      [](char letter) { return std::iscntrl(static_cast<unsigned char>(letter)); });
}

// The word as $'...', which bash, zsh and POSIX of 2024 read; a byte has three octal digits, which
// no letter behind them prolongs.
std::string QuoteBytes(const std::string& word)
{
  std::string quoted = "$'";
  for (const char letter : word)
  {
    const auto byte = static_cast<unsigned char>(letter);
    char number[5];
    std::snprintf(number, sizeof number, "\\%03o", byte);
    const bool plain = byte >= ' ' && byte <= '~' && letter != '\'' && letter != '\\';
    quoted += plain ? std::string(1, letter) : number;
  }
  return quoted + "'";
}

std::string Quote(const std::string& word)
{
  constexpr const char* plain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
  {
    return word;
  }
  if (!IsPrinted(word))
  {
    return QuoteBytes(word);
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
