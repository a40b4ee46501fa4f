// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"

#include "Arguments.h"
#include "Errors.h"
#include "Readers.h"
#include "Values.h"

#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace cli
{
namespace
{
// The default option of a parameter: "--air-label N" for air_label.
std::string MakeUse(const vtkRelievoParameter& parameter)
{
  using P = vtkRelievoParameter;
  static const std::map<P::Types, std::string> forms = { { P::FLAG, "" }, { P::WHOLE, " N" },
    { P::NUMBER, " N" }, { P::CHOICE, " KIND" }, { P::COLOR, " COLOR" }, { P::PAIR, " A,B" },
    { P::VECTOR, " X,Y,Z" }, { P::SIZE, " WxHxD" }, { P::DATE, " YYYY-MM-DD" },
    { P::BOX, " X,X,Y,Y,Z,Z" }, { P::TEXT, " TEXT" } };
  std::string name = parameter.Name;
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name + forms.at(parameter.Type);
}

// Whether the letters on both sides of a place belong to one word.
bool IsWithinWord(const std::string& text, std::size_t at)
{
  const auto isLetter = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  return at > 0 && at < text.size() && isLetter(text[at - 1]) && isLetter(text[at]);
}

// Regular expressions would take a tenth of the time of relievo --help.
void ReplaceWord(std::string& text, const std::string& word, const std::string& by)
{
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at))
  {
    if (IsWithinWord(text, at) || IsWithinWord(text, at + word.size()))
    {
      at += word.size();
      continue;
    }
    text.replace(at, word.size(), by);
    at += by.size();
  }
}
}

//------------------------------------------------------------------------------
Command::Command(const std::string& name, const std::string& use, const std::string& about)
{
  this->Rows.Name = name;
  this->Rows.Use = use;
  this->Rows.About = about;
}

//------------------------------------------------------------------------------
vtkRelievoOption& Command::Add(const std::string& use, const std::string& help,
  const std::function<void(const std::string& value)>& take)
{
  const std::size_t blank = use.find(' ');
  vtkRelievoOption option;
  option.Name = use.substr(0, blank);
  option.Form = blank == std::string::npos ? "" : use.substr(blank + 1);
  option.Help = help;
  option.Take = [take](const std::string& value) {
    take(value);
    return std::string();
  };
  this->Rows.Options.push_back(option);
  return this->Rows.Options.back();
}

//------------------------------------------------------------------------------
vtkRelievoOption& Command::AddWord(
  const std::string& use, const std::string& help, std::string& word)
{
  return this->Add(use, help, [&word](const std::string& value) { word = value; });
}

//------------------------------------------------------------------------------
void Command::AddFlag(const std::string& name, const std::string& help, bool& flag)
{
  this->Add(name, help, [&flag](const std::string&) { flag = true; });
}

//------------------------------------------------------------------------------
vtkRelievoOption& Command::AddOutput(
  const std::string& use, const std::string& help, std::string& file, const std::string& other)
{
  const std::string extension = reading::ExtensionOf(use);
  const std::string name = use.substr(0, use.find(' '));
  vtkRelievoOption& option =
    this->Add(use, help, [&file, name, extension, other](const std::string& value) {
      const std::string given = reading::ExtensionOf(value);
      if (given != extension && (other.empty() || given != other))
      {
        words::RefuseValue(
          name, value, "a name that ends in " + extension + (other.empty() ? "" : " or " + other));
      }
      file = value;
    });
  option.Files = extension.substr(1) + (other.empty() ? "" : "|" + other.substr(1));
  return option;
}

//------------------------------------------------------------------------------
void Command::AddMeshOptions(const std::string& extension, const std::string& other)
{
  this->Rows.Files = words::Join(reading::GetExtensions(), "|");
  const bool hasRaster = extension == ".tif" || other == ".tif";
  this
    ->AddOutput("-o FILE" + extension,
      hasRaster ? "the mesh (.vtp), or a raster on the grid of a terrain (.tif)" : "the mesh",
      this->File, other)
    .Missing = "no file to write; give -o FILE" + extension;
  this->AddFolderOption();
  this->AddOutput("--rays FILE.rays",
    "stores the trees for rays of these meshes in a file: the first run writes it, and later runs "
    "share it in memory",
    this->RayFile);
}

//------------------------------------------------------------------------------
void Command::AddFolderOption()
{
  vtkRelievoOption& folders = this->Add("--allow-folder DIR",
    "allows files to name pieces in this folder and below (each file's own folder); "
    "repeatable",
    [this](const std::string& value) { this->AllowedFolders.push_back(value); });
  folders.Files = "/";
  folders.Repeats = true;
}

//------------------------------------------------------------------------------
void Command::AddUpOption()
{
  const std::vector<std::string> axes = { "x", "y", "z" };
  this
    ->Add("--up AXIS",
      "the axis that points up, " + vtkRelievoEither(axes) + " (by the first FILE)",
      [this, axes](const std::string& value) {
        this->Up = static_cast<int>(words::ParseChoice("--up", value, axes));
      })
    .Words = axes;
}

//------------------------------------------------------------------------------
void Command::AddPartOption(const std::string& items)
{
  this
    ->Add("--part K/N",
      "computes only part K of N, equal shares of the " + items +
        ", as one of several processes; relievo merge joins the parts. slurm takes K and N from "
        "the variables of a job array (all)",
      [this](const std::string& value) {
        this->Part = dataset::WorkPart::Parse("--part", value);
        this->IsPart = true;
      })
    .Words = { "slurm" };
}

//------------------------------------------------------------------------------
std::string Command::GetWords() const
{
  return words::Join(this->Given, " ");
}

//------------------------------------------------------------------------------
void Command::AddParameters(
  const vtkRelievoParameterList& list, const std::map<std::string, std::string>& uses)
{
  const std::size_t before = this->Rows.Options.size();
  for (const vtkRelievoParameter& parameter : list.Parameters)
  {
    const auto found = uses.find(parameter.Name);
    const std::string use = found == uses.end() ? MakeUse(parameter) : found->second;
    if (!use.empty())
    {
      this->Rows.Options.push_back(vtkRelievoOption::Of(parameter, use));
      this->OptionOf[vtkRelievoCapitalize(parameter.Name, false)] = this->Rows.Options.back().Name;
    }
  }
  for (std::size_t i = before; i < this->Rows.Options.size(); ++i)
  {
    this->Rows.Options[i].Help = this->NameOptions(this->Rows.Options[i].Help);
  }
}

//------------------------------------------------------------------------------
std::string Command::NameOptions(const std::string& text) const
{
  std::string named = text;
  for (const auto& [parameter, option] : this->OptionOf)
  {
    ReplaceWord(named, parameter, option);
  }
  return named;
}

//------------------------------------------------------------------------------
void Command::Take(const std::vector<std::string>& words)
{
  static const std::set<std::string> apart = { "-o", "--out", "--part", "--allow-folder",
    "--rays" };
  vtkRelievoCommand command = this->DescribeAll();
  for (vtkRelievoOption& option : command.Options)
  {
    if (apart.count(option.Name) == 0)
    {
      option.Take = [this, option](const std::string& value) {
        this->Given.push_back(option.IsFlag() ? option.Name : option.Name + "=" + value);
        return option.Take(value);
      };
    }
  }
  words::TakeArguments(words, command, [this](const std::string& word) {
    if (this->Rows.Use.empty())
    {
      const vtkRelievoOption& first = this->Rows.Options.front();
      throw words::UsageError(this->Rows.Name + ": got '" + word +
        "', expected options; the file is given as " + first.GetUse());
    }
    this->Names.push_back(word);
  });
}

//------------------------------------------------------------------------------
void Command::TakeMeshes(const std::vector<std::string>& words)
{
  this->Take(words);
  if (this->Names.empty())
  {
    throw words::UsageError(this->Rows.Name + ": no FILE given");
  }
  for (const std::string& file : this->Names)
  {
    if (reading::IsModel(file))
    {
      throw words::UsageError(file + ": a model, expected data, such as .vtp, .vtu, .obj or .stl");
    }
    reading::CheckExtension(file);
  }
}
}
