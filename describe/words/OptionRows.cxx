// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionRows.h"

#include "Numbers.h"
#include "Values.h"

namespace words
{
namespace
{
std::string Insert(std::string help, const std::string& mark, const std::string& text)
{
  const std::size_t at = help.find(mark);
  return at == std::string::npos ? help : help.replace(at, mark.size(), text);
}
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::Add(
  const std::string& name, const std::string& form, const std::string& help, const Taker& take)
{
  Option option;
  option.Name = name;
  option.Form = form;
  option.Help = help;
  option.Take = [take](const std::string& word) {
    take(word);
    return std::string();
  };
  this->Command.Options.push_back(option);
  return this->Command.Options.back();
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::AddFlag(const std::string& name, const std::string& help)
{
  return this->Add(name, "", help, [](const std::string&) {});
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::AddFlag(const std::string& name, const std::string& help, bool& flag)
{
  return this->Add(name, "", help, [&flag](const std::string&) { flag = true; });
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::AddText(
  const std::string& name, const std::string& form, const std::string& help, std::string& text)
{
  return this->Add(name, form, help, [&text](const std::string& word) { text = word; });
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::AddParsed(const std::string& name, const std::string& form,
  const std::string& help, const Option::Bounds& range, const std::function<void(double)>& take)
{
  const std::string least = WriteNumber(range.Least), most = WriteNumber(range.Most);
  Option& option = this->Add(name, form,
    Insert(help, "@bounds@",
      range.Open ? "above " + least + " and below " + most : least + " to " + most),
    [=](const std::string& word) {
      const auto parse = range.Open ? ParseNumberBetween : ParseNumberFrom;
      take(parse(name, word, range.Least, range.Most));
    });
  option.Range = range;
  return option;
}

//------------------------------------------------------------------------------
vtkRelievoOption& OptionRows::AddChoice(const std::string& name, const std::string& form,
  const std::vector<std::string>& choices, const std::string& help,
  const std::function<void(std::size_t place)>& take)
{
  Option& option = this->Add(name, form, Insert(help, "@choices@", vtkRelievoEither(choices)),
    [name, choices, take](const std::string& word) {
      const std::size_t place = ParseChoice(name, word, choices);
      if (take)
      {
        take(place);
      }
    });
  option.Words = choices;
  return option;
}
}
