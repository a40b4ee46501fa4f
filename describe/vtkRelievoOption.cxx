// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOption.h"

#include "vtkRelievoParameter.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>

namespace
{
constexpr std::size_t Indent = 26; // column of the help texts
constexpr std::size_t Columns = 98;

// Adds a paragraph whose first line continues a column and whose other lines are indented.
void AddParagraph(
  const std::string& text, std::size_t column, std::size_t indent, std::string& page)
{
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false)
  {
    if (!first && column + 1 + word.size() > Columns)
    {
      page += "\n" + std::string(indent, ' ');
      column = indent;
      first = true;
    }
    page += (first ? "" : " ") + word;
    column += (first ? 0 : 1) + word.size();
  }
  page += '\n';
}

// Adds a line of a table, unchanged if it is short.
void AddTableLine(const std::string& line, std::string& page)
{
  if (Indent + line.size() <= Columns)
  {
    page += line + "\n";
    return;
  }
  page += "  ";
  AddParagraph(line, Indent, Indent + 6, page);
}

std::string WriteHelp(const std::string& use, const std::string& help)
{
  std::string page = "  " + use;
  page += page.size() + 2 > Indent ? "\n" + std::string(Indent, ' ')
                                   : std::string(Indent - page.size(), ' ');
  std::istringstream paragraphs(help);
  bool first = true;
  for (std::string paragraph; std::getline(paragraphs, paragraph); first = false)
  {
    page += first ? "" : std::string(Indent, ' ');
    paragraph[0] == ' ' ? AddTableLine(paragraph, page)
                        : AddParagraph(paragraph, Indent, Indent, page);
  }
  return page;
}

// Turns "Whether it is on." into "whether it is on".
std::string AsPart(std::string sentence)
{
  sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  if (sentence.back() == '.')
  {
    sentence.pop_back();
  }
  return sentence;
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoEither(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}

//------------------------------------------------------------------------------
vtkRelievoOption& vtkRelievoOption::Is(unsigned traits)
{
  this->Traits |= traits;
  return *this;
}

//------------------------------------------------------------------------------
vtkRelievoOption& vtkRelievoOption::DropAs(const std::string& value)
{
  this->Dropped = value;
  return this->Is(OF_FILES);
}

//------------------------------------------------------------------------------
vtkRelievoOption& vtkRelievoOption::RefuseLens(const std::string& reason)
{
  this->NotWithLens = reason;
  return *this;
}

//------------------------------------------------------------------------------
vtkRelievoOption& vtkRelievoOption::ShowIn(const std::string& panel, const std::string& label)
{
  this->Panel = panel;
  this->Label = label;
  return *this;
}

//------------------------------------------------------------------------------
vtkRelievoOption& vtkRelievoOption::NamedIn(const std::string& panel, const std::string& label)
{
  this->HasOwnControl = true;
  return this->ShowIn(panel, label);
}

//------------------------------------------------------------------------------
vtkRelievoOption vtkRelievoOption::Of(const vtkRelievoParameter& parameter, const std::string& use)
{
  using P = vtkRelievoParameter;
  vtkRelievoOption option;
  const std::size_t blank = use.find(' ');
  option.Name = use.substr(0, blank);
  option.Form = blank == std::string::npos ? "" : use.substr(blank + 1);
  option.Help = AsPart(parameter.Help);
  option.Words = parameter.Choices;
  if (parameter.Type == P::CHOICE)
  {
    const bool told = std::all_of(parameter.Choices.begin(), parameter.Choices.end(),
      [&](const std::string& choice) { return option.Help.find(choice) != std::string::npos; });
    option.Help += told ? "" : ": " + vtkRelievoEither(parameter.Choices);
  }
  else if (parameter.Type != P::FLAG && parameter.Type != P::TEXT)
  {
    const bool bounded = parameter.Least > std::numeric_limits<int>::min() &&
      parameter.Most < std::numeric_limits<int>::max();
    const std::string from = "from ", bounds = parameter.GetBounds();
    option.Help +=
      bounded ? ", " + bounds.substr(bounds.rfind(from, 0) == 0 ? from.size() : 0) : "";
    option.Help += parameter.Unit.empty() ? "" : (bounded ? " " : ", ") + parameter.Unit;
  }
  option.Help += parameter.Type == P::FLAG ? "" : " (" + parameter.Format() + ")";
  const std::string form = parameter.GetNumberOfComponents() > 1 ? option.Form + ", " : "";
  option.Take = [parameter, form](const std::string& value) -> std::string {
    const bool taken = parameter.Parse(parameter.Type == P::FLAG ? "on" : value).empty();
    return taken ? "" : "got '" + value + "', expected " + form + parameter.GetExpected();
  };
  return option;
}

//------------------------------------------------------------------------------
const vtkRelievoOption* vtkRelievoCommand::Find(const std::string& option) const
{
  const auto found = std::find_if(this->Options.begin(), this->Options.end(),
    [&option](const vtkRelievoOption& each) { return each.Name == option; });
  return found == this->Options.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::string vtkRelievoCommand::GetUse() const
{
  std::string use = this->Name + (this->Use.empty() ? "" : " " + this->Use);
  bool optional = false;
  for (const vtkRelievoOption& option : this->Options)
  {
    use += option.Missing.empty() ? "" : " " + option.GetUse();
    optional = optional || option.Missing.empty();
  }
  return use + (optional ? " [options]" : "");
}

//------------------------------------------------------------------------------
std::string vtkRelievoCommand::GetHelp() const
{
  std::string page;
  AddParagraph(this->About, 0, 2, page);
  page += this->Options.empty() ? "" : "\n";
  page += this->AboutFile.empty() ? "" : WriteHelp("FILE", this->AboutFile);
  for (const vtkRelievoOption& option : this->Options)
  {
    page += WriteHelp(option.GetUse(), option.Help);
  }
  return page;
}

//------------------------------------------------------------------------------
std::string vtkRelievoCommand::GetWords() const
{
  std::string lines = this->Name + " . " + (this->Files.empty() ? "none" : this->Files) + "\n";
  for (const vtkRelievoOption& option : this->Options)
  {
    lines += this->Name + " " + option.Name + " " +
      (option.IsFlag()           ? "flag"
          : option.Files.empty() ? "value"
                                 : option.Files);
    for (const std::string& word : option.Words)
    {
      lines += " " + word;
    }
    lines += "\n";
  }
  return lines;
}
