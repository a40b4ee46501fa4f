// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Parses values of options to numbers and choices. Numbers parse the same in every locale. Each
 * function throws UsageError naming the option, the word and the expected value.
 */
#ifndef Values_h
#define Values_h

#include <string>
#include <utility>
#include <vector>

struct vtkRelievoParameterList;

namespace words
{
/// Names with their values in words.
using NamedWords = std::vector<std::pair<std::string, std::string>>;

/// The error for an invalid word: "OPTION: got 'WORD', expected EXPECTED".
[[noreturn]] void RefuseValue(
  const std::string& option, const std::string& word, const std::string& expected);

/// The parts of a word between separators; an empty word has one empty part.
std::vector<std::string> Split(const std::string& word, char separator);

/// Split, except that a backslash before a separator or a backslash makes it an ordinary letter.
std::vector<std::string> SplitEscaped(const std::string& word, char separator);

/// A word that SplitEscaped splits into these parts.
std::string JoinEscaped(const std::vector<std::string>& parts, char separator);

/// Joins the parts, with a separator between each two.
std::string Join(const std::vector<std::string>& parts, const std::string& separator);

/// Exactly `count` finite numbers between commas. `form` shows the shape, such as "NEAR,FAR".
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& word, std::size_t count, const std::string& form);

/// One finite number with low < number < high.
double ParseNumberBetween(
  const std::string& option, const std::string& word, double low, double high);

/// One finite number with low <= number <= high.
double ParseNumberFrom(const std::string& option, const std::string& word, double low, double high);

/// A share: a number between 0 and 1, or a percentage such as 0.05%.
double ParseShare(const std::string& option, const std::string& word);

/// One whole number with low <= number <= high.
int ParseWhole(const std::string& option, const std::string& word, int low, int high);

/// The values of NAME=VALUE parts, each name once. `form` shows the shape of the whole word.
NamedWords ParseNamedWords(
  const std::string& option, const std::vector<std::string>& parts, const std::string& form);

/// Writes the parts that ParseNamedWords parses, with commas between them.
std::string WriteNamedWords(const NamedWords& values);

/// The value of a name; "" if it has none.
std::string FindWords(const NamedWords& values, const std::string& name);

/// Sets the value of a name; "" removes it.
void SetWords(NamedWords& values, const std::string& name, const std::string& words);

/// Describes parameters as text: a line NAME=VALUE with help and default for each.
std::string DescribeValues(const vtkRelievoParameterList& values);

/// The index of the word among the choices.
std::size_t ParseChoice(
  const std::string& option, const std::string& word, const std::vector<std::string>& choices);
}

#endif
