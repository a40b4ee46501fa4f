// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values of options: from a word to numbers and choices. Numbers read the same in every locale.
 * Each function throws UsageError that names the option, the word and what was expected.
 */
#ifndef Values_h
#define Values_h

#include <string>
#include <utility>
#include <vector>

struct vtkRelievoParameterList;

namespace scene
{
/// Names with what is said of each, in words.
using NamedWords = std::vector<std::pair<std::string, std::string>>;

/// The error for a word that does not fit: "OPTION: got 'WORD', expected EXPECTED".
[[noreturn]] void RefuseValue(
  const std::string& option, const std::string& word, const std::string& expected);

/// The parts of a word between separators; an empty word has one empty part.
std::vector<std::string> Split(const std::string& word, char separator);

/// The parts of a word between separators; a backslash before a separator or a backslash stands for
/// the letter itself.
std::vector<std::string> SplitEscaped(const std::string& word, char separator);

/// The word that SplitEscaped takes apart so.
std::string JoinEscaped(const std::vector<std::string>& parts, char separator);

/// The parts with a separator between each two.
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

/// What NAME=VALUE parts say, each name once. `form` shows the shape of the whole word.
NamedWords ParseNamedWords(
  const std::string& option, const std::vector<std::string>& parts, const std::string& form);

/// The parts that ParseNamedWords reads so, with commas between them.
std::string WriteNamedWords(const NamedWords& values);

/// What is said of the name; "" if nothing is.
std::string FindWords(const NamedWords& values, const std::string& name);

/// Says it of the name; "" takes it back.
void SetWords(NamedWords& values, const std::string& name, const std::string& words);

/// Values that a class describes, for people: a line NAME=VALUE with its help and default for each.
std::string DescribeValues(const vtkRelievoParameterList& values);

/// The place of the word among the choices.
std::size_t ParseChoice(
  const std::string& option, const std::string& word, const std::vector<std::string>& choices);
}

#endif
