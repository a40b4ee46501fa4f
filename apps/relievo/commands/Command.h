// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Command_h
#define Command_h

#include "WorkPart.h"

#include "vtkRelievoOption.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct vtkRelievoParameterList;

namespace cli
{
/// A command of `relievo`: its options, each described once, and its work. Errors are thrown as
/// words::UsageError or words::WorkError.
class Command
{
public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  void operator=(const Command&) = delete;

  /// The command's own options, and its help.
  const vtkRelievoCommand& Describe() const { return this->Rows; }

  /// All options that the command accepts.
  virtual vtkRelievoCommand DescribeAll() { return this->Rows; }

  /// Parses the words after the command's name, and runs it. Returns the exit status.
  virtual int Run(const std::vector<std::string>& words) = 0;

protected:
  /// `use`: the words after the name, such as FILE...; "" if there are only options. `about`: a
  /// paragraph.
  Command(const std::string& name, const std::string& use, const std::string& about);

  ///@{
  /// Adds an option. `use`: its name and its value's placeholder, such as "--seed N".
  vtkRelievoOption& Add(const std::string& use, const std::string& help,
    const std::function<void(const std::string& value)>& take);
  vtkRelievoOption& AddWord(const std::string& use, const std::string& help, std::string& word);
  void AddFlag(const std::string& name, const std::string& help, bool& flag);
  ///@}

  /// Adds an option for an output file with the extension at the end of its use, "-o FILE.vtp", or
  /// with another one.
  vtkRelievoOption& AddOutput(const std::string& use, const std::string& help, std::string& file,
    const std::string& other = "");

  /// Adds the options of commands that trace rays at a mesh: -o with one or two extensions,
  /// --allow-folder and --rays.
  void AddMeshOptions(const std::string& extension, const std::string& other = "");

  /// Adds --allow-folder, for commands that read meshes.
  void AddFolderOption();

  /// Adds --up, whose value is -1 if it is not given.
  void AddUpOption();

  /// Adds --part, for work that several processes share.
  void AddPartOption(const std::string& items);

  /// The given options as words, without those of outputs and of parts.
  std::string GetWords() const;

  /// Adds the parameters of a filter, in their order. `uses` replaces the default of a parameter's
  /// option ("--day-step N"); "" omits the parameter.
  void AddParameters(
    const vtkRelievoParameterList& list, const std::map<std::string, std::string>& uses);

  /// A filter's message, with parameters replaced by the names of their options.
  std::string NameOptions(const std::string& text) const;

  /// Passes values to the options. Plain words become Names; names of meshes are checked.
  void Take(const std::vector<std::string>& words);
  void TakeMeshes(const std::vector<std::string>& words);

  vtkRelievoCommand Rows;
  std::vector<std::string> Names; ///< words other than options
  std::vector<std::string> AllowedFolders;
  std::string RayFile; ///< value of --rays; "": none
  std::string File;    ///< value of -o
  int Up = -1;
  dataset::WorkPart Part; ///< value of --part
  bool IsPart = false;    ///< whether it is given

private:
  std::vector<std::string> Given;              // options, as words
  std::map<std::string, std::string> OptionOf; // by the parameter's name in methods
};

///@{
/// Each is defined in a file of its own.
std::unique_ptr<Command> MakeBench();
std::unique_ptr<Command> MakeCave();
std::unique_ptr<Command> MakeCompare();
std::unique_ptr<Command> MakeCover();
std::unique_ptr<Command> MakeDataset();
std::unique_ptr<Command> MakeMerge();
std::unique_ptr<Command> MakeRender();
std::unique_ptr<Command> MakeStages();
std::unique_ptr<Command> MakeStatus();
std::unique_ptr<Command> MakeSun();
std::unique_ptr<Command> MakeVerify();
std::unique_ptr<Command> MakeViewFactors();
std::unique_ptr<Command> MakeViewshed();
std::unique_ptr<Command> MakeVisible();
///@}
}

#endif
