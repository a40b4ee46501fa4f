// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes the rows of a command: its options, each described by the code that uses its value.
 */
#ifndef OptionRows_h
#define OptionRows_h

#include "Arguments.h"
#include "vtkRelievoOption.h"

#include <functional>
#include <string>
#include <vector>

namespace words
{
/// Each function adds an option, whose value goes to `take` or to a variable that must outlive the
/// command, and returns it for further traits; it may move when the next option is added.
class OptionRows
{
public:
  using Option = vtkRelievoOption;
  using Taker = std::function<void(const std::string& word)>; ///< throws UsageError

  vtkRelievoCommand Command;

  Option& Add(
    const std::string& name, const std::string& form, const std::string& help, const Taker& take);

  template <typename Choice>
  Option& Add(const std::string& name, const std::string& form, const std::string& help,
    Choice& choice, void (*take)(Choice& choice, const std::string& word))
  {
    return this->Add(
      name, form, help, [&choice, take](const std::string& word) { take(choice, word); });
  }

  ///@{
  /// Without a variable, the code that uses the option asks whether it was given.
  Option& AddFlag(const std::string& name, const std::string& help);
  Option& AddFlag(const std::string& name, const std::string& help, bool& flag);
  ///@}

  /// Any text.
  Option& AddText(
    const std::string& name, const std::string& form, const std::string& help, std::string& text);

  /// The bounds replace @bounds@ in the help. Number: double, or optional.
  template <typename Number>
  Option& AddNumber(const std::string& name, const std::string& form, const std::string& help,
    const Option::Bounds& range, Number& number)
  {
    return this->AddParsed(name, form, help, range, [&number](double parsed) { number = parsed; });
  }

  /// The code that uses the number asks for it by the option's name.
  Option& AddNumber(const std::string& name, const std::string& form, const std::string& help,
    const Option::Bounds& range, GivenNumbers& numbers)
  {
    return this->AddParsed(
      name, form, help, range, [&numbers, name](double parsed) { numbers.Set(name, parsed); });
  }

  /// The choices replace @choices@ in the help; `take`, if any, gets the index.
  Option& AddChoice(const std::string& name, const std::string& form,
    const std::vector<std::string>& choices, const std::string& help,
    const std::function<void(std::size_t place)>& take = nullptr);

private:
  Option& AddParsed(const std::string& name, const std::string& form, const std::string& help,
    const Option::Bounds& range, const std::function<void(double)>& take);
};
}

#endif
