// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The viewer's settings as words of `relievo render`: files, and options with their values. Every
 * stage has at most one --stage; options that are synonyms for its parameters (--tone, --deferred,
 * --shadow-size ...) are converted to it, except those that switch a stage (--shadows).
 * Outputs are not part of the settings.
 */
#ifndef Settings_h
#define Settings_h

#include "Numbers.h" // for the values
#include "SceneNames.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

struct vtkRelievoOption;

namespace scene
{
struct RenderOptions;

class Settings
{
public:
  std::vector<std::string> Files;

  /// Throws UsageError for words that `relievo render` refuses, except for missing outputs.
  static Settings FromWords(const std::vector<std::string>& words);

  /// Makes the paths of all options absolute, relative to a folder: they work in another shell too.
  void MakePathsAbsolute(const std::string& folder);

  /// Makes paths in the folder and below relative, to move with it; others stay absolute.
  void MakePathsRelative(const std::string& folder);

  /// Options, then files.
  std::vector<std::string> GetWords() const;

  /// The command line's options for the words; throws UsageError.
  RenderOptions Parse() const;

  bool Has(const std::string& option) const { return this->Values.count(option) != 0; }

  /// The words of an option, including those of stages.
  std::vector<std::string> GetAllWords(const std::string& option) const;

  /// The first value; "" if it was not given.
  std::string Get(const std::string& option) const;
  std::vector<std::string> GetAll(const std::string& option) const;

  /// Replaces all values by one; a flag's is "".
  void Set(const std::string& option, const std::string& value);
  void SetAll(const std::string& option, const std::vector<std::string>& values);
  void Remove(const std::string& option) { this->Values.erase(option); }

  ///@{
  /// Stages. A parameter's value is in words; the value of a missing one is the preset's or the
  /// default.
  /// Setting a parameter requests its stage.
  bool IsStageAsked(const std::string& stage) const { return this->Stages.count(stage) != 0; }
  void AskStage(const std::string& stage, bool asked);
  bool HasParameter(const std::string& stage, const std::string& parameter) const
  {
    return this->Find(stage, parameter) != nullptr;
  }
  std::string GetParameter(const std::string& stage, const std::string& parameter) const;
  void SetParameter(
    const std::string& stage, const std::string& parameter, const std::string& value);

  /// Whether the picture has the stage, by these words or by the preset.
  bool IsStageOn(const std::string& stage) const;
  void SwitchStage(const std::string& stage, bool on);
  ///@}

  /// Options, and STAGE:PARAMETER, with different values in `other`; "" for files.
  std::set<std::string> GetChanges(const Settings& other) const;

  /// Applies the differences between `before` and `after`, except files, to these settings.
  void TakeChanges(const Settings& before, const Settings& after);

  bool operator==(const Settings& other) const;
  bool operator!=(const Settings& other) const { return !(*this == other); }

private:
  using Parameters = std::vector<std::pair<std::string, std::string>>;

  using PathChange = std::string (*)(const std::string& path, const std::string& folder);

  void ChangePaths(const std::string& folder, PathChange change);
  void TakeStages(const RenderOptions& options);
  void DropValue(const std::string& option, const std::string& name);
  bool IsSwitchedOn(const vtkRelievoOption& option) const;
  void SetSwitch(const vtkRelievoOption& option, bool on, const std::string& value);
  std::string GetStandard(const std::string& stage, const std::string& parameter) const;
  const std::string* Find(const std::string& stage, const std::string& parameter) const;
  void SetGiven(const std::string& stage, const std::string& parameter, const std::string& value);

  std::map<std::string, std::vector<std::string>> Values; // by option
  std::map<std::string, Parameters> Stages;               // by name
};
}

#endif
