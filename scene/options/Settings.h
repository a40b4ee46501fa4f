// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All that the window shows, as the words of `relievo render`: files, and options with their
 * values. Every stage has at most one --stage; options that are another way to say the same
 * (--tone, --deferred, --shadow-size ...) become that word, and whether shadows are seen, and by
 * which method, is --shadows. What is written, and where, is no part of it.
 */
#ifndef Settings_h
#define Settings_h

#include "Numbers.h" // for the values

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace scene
{
struct RenderOptions;

class Settings
{
public:
  std::vector<std::string> Files;

  /// Throws UsageError for words that `relievo render` refuses, outputs apart.
  static Settings FromWords(const std::vector<std::string>& words);

  /// Files of all options as seen from a folder: they hold in another one's shell too.
  void MakePathsAbsolute(const std::string& folder);

  /// Those in the folder and below, which move with it; others stay absolute.
  void MakePathsRelative(const std::string& folder);

  /// Options, then files.
  std::vector<std::string> GetWords() const;

  /// What the command line makes of the words; throws UsageError.
  RenderOptions Parse() const;

  bool Has(const std::string& option) const { return this->Values.count(option) != 0; }

  /// The words of an option, those of stages among them.
  std::vector<std::string> GetAllWords(const std::string& option) const;

  /// The first value; "" if it was not given.
  std::string Get(const std::string& option) const;
  std::vector<std::string> GetAll(const std::string& option) const;

  /// One value instead of all; a flag's is "".
  void Set(const std::string& option, const std::string& value);
  void SetAll(const std::string& option, const std::vector<std::string>& values);
  void Remove(const std::string& option) { this->Values.erase(option); }

  ///@{
  /// Stages. A parameter's value is in words; that of one that was not given is the
  /// preset's or its default.
  /// Setting a parameter asks for its stage.
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

  /// Options, and STAGE:PARAMETER, that the other says differently; "" for files.
  std::set<std::string> GetChanges(const Settings& other) const;

  /// What `after` says differently than `before`, files apart, is said here as well.
  void TakeChanges(const Settings& before, const Settings& after);

  bool operator==(const Settings& other) const;
  bool operator!=(const Settings& other) const { return !(*this == other); }

private:
  using Parameters = std::vector<std::pair<std::string, std::string>>;

  using PathChange = std::string (*)(const std::string& path, const std::string& folder);

  void ChangePaths(const std::string& folder, PathChange change);
  void TakeStages(const RenderOptions& options);
  void DropValue(const std::string& option, const std::string& name);
  bool ShowsShadows() const;
  void SetShadows(bool on, const std::string& method);
  std::string GetStandard(const std::string& stage, const std::string& parameter) const;
  const std::string* Find(const std::string& stage, const std::string& parameter) const;
  void SetGiven(const std::string& stage, const std::string& parameter, const std::string& value);

  std::map<std::string, std::vector<std::string>> Values; // by option
  std::map<std::string, Parameters> Stages;               // by name
};
}

#endif
