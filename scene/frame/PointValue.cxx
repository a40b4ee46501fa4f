// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointValue.h"

#include "Errors.h"
#include "Values.h"

#include <set>

namespace scene
{
namespace
{
// Whether the word is meant as a number: arrays may be called anything else.
bool IsNumber(const std::string& word)
{
  try
  {
    ParseNumbers("", word, 1, "");
    return true;
  }
  catch (const UsageError&)
  {
    return word.empty();
  }
}
}

//------------------------------------------------------------------------------
PointValue ParsePointValue(const std::string& option, const std::string& word, double least)
{
  PointValue value;
  if (!IsNumber(word))
  {
    value.Array = word;
    return value;
  }
  value.Number = ParseNumbers(option, word, 1, "a number, or the name of a point array").front();
  if (*value.Number < least)
  {
    RefuseValue(option, word, "0 or more");
  }
  return value;
}

//------------------------------------------------------------------------------
ColorValue ParseColorValue(const std::string& option, const std::string& word)
{
  ColorValue value;
  if (word.find('/') == std::string::npos)
  {
    value.Array = word;
  }
  else
  {
    value.Color = ParseThree(option, word);
  }
  return value;
}

//------------------------------------------------------------------------------
std::array<double, 3> ParseThree(const std::string& option, const std::string& word)
{
  const char* const form = "three numbers, such as 1/0.8/0.5";
  const std::vector<std::string> parts = Split(word, '/');
  if (parts.size() != 3)
  {
    RefuseValue(option, word, form);
  }
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    numbers[i] = ParseNumbers(option, parts[i], 1, form).front();
  }
  return numbers;
}

//------------------------------------------------------------------------------
std::string ParseFileAndValues(const std::string& option, const std::string& word,
  const std::string& form, std::vector<std::pair<std::string, std::string>>& values)
{
  const std::vector<std::string> parts = SplitEscaped(word, ',');
  if (parts.front().empty())
  {
    RefuseValue(option, word, form);
  }
  std::set<std::string> given;
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    const std::string name = parts[i].substr(0, equals);
    if (equals == std::string::npos || !given.insert(name).second)
    {
      RefuseValue(option, parts[i], form + ", each once");
    }
    values.emplace_back(name, parts[i].substr(equals + 1));
  }
  return parts.front();
}

//------------------------------------------------------------------------------
std::string WriteFileAndValues(
  const std::string& file, const std::vector<std::pair<std::string, std::string>>& values)
{
  std::vector<std::string> parts = { file };
  for (const auto& value : values)
  {
    parts.push_back(value.first + "=" + value.second);
  }
  return JoinEscaped(parts, ',');
}
}
