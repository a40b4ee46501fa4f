// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "Errors.h"

#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace words
{
namespace
{
// std::from_chars and not strtod: a decimal comma of the locale must not change what "0.5" means.
template <typename T>
bool ReadWhole(const std::string& word, T& value)
{
  const char* end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

bool ReadFinite(const std::string& word, double& value)
{
  return ReadWhole(word, value) && std::isfinite(value);
}

template <typename Values>
auto FindNamed(Values& values, const std::string& name)
{
  return std::find_if(
    values.begin(), values.end(), [&name](const auto& each) { return each.first == name; });
}

std::string Show(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}
}

//------------------------------------------------------------------------------
void RefuseValue(const std::string& option, const std::string& word, const std::string& expected)
{
  throw UsageError(option + ": got '" + word + "', expected " + expected);
}

//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& word, char separator)
{
  std::vector<std::string> parts;
  std::string::size_type begin = 0;
  for (;;)
  {
    const std::string::size_type end = word.find(separator, begin);
    parts.push_back(word.substr(begin, end == std::string::npos ? end : end - begin));
    if (end == std::string::npos)
    {
      return parts;
    }
    begin = end + 1;
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitEscaped(const std::string& word, char separator)
{
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < word.size(); ++i)
  {
    const bool escaped =
      word[i] == '\\' && i + 1 < word.size() && (word[i + 1] == separator || word[i + 1] == '\\');
    if (escaped)
    {
      parts.back() += word[++i];
    }
    else if (word[i] == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += word[i];
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
std::string JoinEscaped(const std::vector<std::string>& parts, char separator)
{
  std::string word;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    word += i ? std::string(1, separator) : "";
    for (const char letter : parts[i])
    {
      word +=
        letter == separator || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
    }
  }
  return word;
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& parts, const std::string& separator)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i ? separator : "") + parts[i];
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& word, std::size_t count, const std::string& form)
{
  const std::vector<std::string> parts = Split(word, ',');
  std::vector<double> numbers(parts.size());
  bool good = parts.size() == count;
  for (std::size_t i = 0; good && i < count; ++i)
  {
    good = ReadFinite(parts[i], numbers[i]);
  }
  if (!good)
  {
    RefuseValue(option, word,
      (count == 1 ? "a finite number: " : std::to_string(count) + " finite numbers: ") + form);
  }
  return numbers;
}

//------------------------------------------------------------------------------
double ParseNumberBetween(
  const std::string& option, const std::string& word, double low, double high)
{
  double number = 0.0;
  if (!ReadFinite(word, number) || number <= low || number >= high)
  {
    RefuseValue(option, word,
      std::isfinite(high) ? "a number between " + Show(low) + " and " + Show(high)
                          : "a finite number above " + Show(low));
  }
  return number;
}

//------------------------------------------------------------------------------
double ParseNumberFrom(const std::string& option, const std::string& word, double low, double high)
{
  double number = 0.0;
  if (!ReadFinite(word, number) || number < low || number > high)
  {
    RefuseValue(option, word,
      std::isfinite(high) ? "a number from " + Show(low) + " to " + Show(high)
                          : "a finite number from " + Show(low) + " on");
  }
  return number;
}

//------------------------------------------------------------------------------
double ParseShare(const std::string& option, const std::string& word)
{
  const bool percent = !word.empty() && word.back() == '%';
  const double whole = percent ? 100.0 : 1.0;
  double number = 0.0;
  if (!ReadFinite(percent ? word.substr(0, word.size() - 1) : word, number) || number <= 0.0 ||
    number >= whole)
  {
    RefuseValue(option, word, "a number between 0 and 1, or a percentage between 0% and 100%");
  }
  return number / whole;
}

//------------------------------------------------------------------------------
int ParseWhole(const std::string& option, const std::string& word, int low, int high)
{
  int number = 0;
  if (!ReadWhole(word, number) || number < low || number > high)
  {
    RefuseValue(
      option, word, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return number;
}

//------------------------------------------------------------------------------
NamedWords ParseNamedWords(
  const std::string& option, const std::vector<std::string>& parts, const std::string& form)
{
  NamedWords values;
  for (const std::string& part : parts)
  {
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    if (equals == std::string::npos || FindNamed(values, name) != values.end())
    {
      RefuseValue(option, part, form + ", each once");
    }
    values.emplace_back(name, part.substr(equals + 1));
  }
  return values;
}

//------------------------------------------------------------------------------
std::string WriteNamedWords(const NamedWords& values)
{
  std::vector<std::string> parts;
  for (const auto& [name, words] : values)
  {
    parts.push_back(name + "=" + words);
  }
  return JoinEscaped(parts, ',');
}

//------------------------------------------------------------------------------
std::string FindWords(const NamedWords& values, const std::string& name)
{
  const auto found = FindNamed(values, name);
  return found == values.end() ? "" : found->second;
}

//------------------------------------------------------------------------------
void SetWords(NamedWords& values, const std::string& name, const std::string& words)
{
  const auto found = FindNamed(values, name);
  if (words.empty() && found != values.end())
  {
    values.erase(found);
  }
  else if (found != values.end())
  {
    found->second = words;
  }
  else if (!words.empty())
  {
    values.emplace_back(name, words);
  }
}

//------------------------------------------------------------------------------
std::string DescribeValues(const vtkRelievoParameterList& values)
{
  std::string text;
  for (const vtkRelievoParameter& parameter : values.Parameters)
  {
    const std::string unit = parameter.Unit.empty() ? "" : ", " + parameter.Unit;
    const int count = parameter.GetNumberOfComponents();
    std::string form = parameter.Type == vtkRelievoParameter::FLAG ? "on|off"
      : count == 3                                                 ? "A/B/C"
      : count == 2                                                 ? "A/B"
                                                                   : "N";
    for (const std::string& choice : parameter.Choices)
    {
      form = (choice == parameter.Choices.front() ? "" : form + "|") + choice;
    }
    std::string standard = parameter.Default;
    std::replace(standard.begin(), standard.end(), ',', '/');
    text +=
      "\n  " + parameter.Name + "=" + form + "  " + parameter.Help + " (" + standard + unit + ")";
  }
  return text;
}

//------------------------------------------------------------------------------
std::size_t ParseChoice(
  const std::string& option, const std::string& word, const std::vector<std::string>& choices)
{
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (found == choices.end())
  {
    RefuseValue(option, word, "one of " + Join(choices, ", "));
  }
  return static_cast<std::size_t>(found - choices.begin());
}
}
