// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Command_h
#define Command_h

#include "vtkRelievoOption.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

struct vtkRelievoParameterList;

namespace cli
{
/// A command of `relievo`: its options, each described once, and its work. Errors are thrown:
/// scene::UsageError, scene::WorkError.
class Command
{
public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  void operator=(const Command&) = delete;

  /// Its own options, and the help.
  const vtkRelievoCommand& Describe() const { return this->Rows; }

  /// All that it takes.
  virtual vtkRelievoCommand DescribeAll() { return this->Rows; }

  /// Takes the words behind its name, and works. Returns the exit status.
  virtual int Run(const std::vector<std::string>& words) = 0;

protected:
  /// `use`: what stands behind the name, such as FILE...; "" if options alone do. `about`: a
  /// paragraph.
  Command(const std::string& name, const std::string& use, const std::string& about);

  ///@{
  /// Adds an option. `use`: its name, and what its value is called, such as "--seed N".
  vtkRelievoOption& Add(const std::string& use, const std::string& help,
    const std::function<void(const std::string& value)>& take);
  vtkRelievoOption& AddWord(const std::string& use, const std::string& help, std::string& word);
  void AddFlag(const std::string& name, const std::string& help, bool& flag);
  ///@}

  /// One for a file to write, of the extension that its use ends in: "-o FILE.vtp".
  vtkRelievoOption& AddOutput(const std::string& use, const std::string& help, std::string& file);

  /// What commands that read meshes share: -o, --allow-folder and --up, which is -1 if it is not
  /// given.
  void AddMeshOptions(const std::string& extension);

  /// Those of a filter's parameters, in their order. `uses` has the words where they are not those
  /// of the parameter ("--day-step N"); "" leaves it out.
  void AddParameters(
    const vtkRelievoParameterList& list, const std::map<std::string, std::string>& uses);

  /// What a filter says of its parameters, with the names of the options that set them.
  std::string NameOptions(const std::string& text) const;

  /// Has the options take their values. Plain words go to Names; those of meshes are checked.
  std::set<std::string> Take(const std::vector<std::string>& words);
  void TakeMeshes(const std::vector<std::string>& words);

  vtkRelievoCommand Rows;
  std::vector<std::string> Names; ///< words that are no options
  std::vector<std::string> AllowedFolders;
  std::string File; ///< of -o
  int Up = -1;

private:
  std::map<std::string, std::string> OptionOf; // by the parameter's name as methods have it
};

///@{
/// Each is made in a file of its own.
std::unique_ptr<Command> MakeBench();
std::unique_ptr<Command> MakeCave();
std::unique_ptr<Command> MakeCompare();
std::unique_ptr<Command> MakeDataset();
std::unique_ptr<Command> MakeRender();
std::unique_ptr<Command> MakeStages();
std::unique_ptr<Command> MakeSun();
std::unique_ptr<Command> MakeVisible();
///@}
}

#endif
