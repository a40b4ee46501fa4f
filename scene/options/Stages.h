// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Stages of the frame on the command line: --stage NAME[:PARAMETER=VALUE,...], and options of their
 * own. The stages' descriptions define the names and values.
 */
#ifndef Stages_h
#define Stages_h

#include "SceneNames.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkRelievoPass;
struct vtkRelievoOption;

namespace scene
{
struct StageChoice
{
  std::string Name;
  std::vector<std::pair<std::string, std::string>> Parameters; ///< name and value, as given
  std::string Option = "--stage";                              ///< option of the request
};

/// Adds a request for a stage, made by its own option, after the earlier ones.
StageChoice& AddStage(
  std::vector<StageChoice>& stages, const std::string& name, const std::string& option);

/// Parses the value of --stage. A value extends over commas up to the next PARAMETER=. For stages
/// that work while off, `visible` is an older name of `enabled`, and the name alone sets it.
StageChoice ParseStage(const std::string& word);

/// Last value of a parameter among the requests, or among those of one option; nullptr: none.
const std::string* FindStageChoice(const std::vector<StageChoice>& stages, const std::string& name,
  const std::string& parameter, const std::string& option = "");

/// A new frame, to query the descriptions of its stages.
vtkRelievoPass* GetNewFrame();

/// Throws UsageError if a frame has no such stage, or if the stage refuses a parameter's value.
void CheckStages(const std::vector<StageChoice>& stages);

/// Switches the stages on, with their parameters; stages that work while off need `enabled=on`.
void SetStages(vtkRelievoPass* pass, const std::vector<StageChoice>& stages);

/// Whether the stage `ambient` is on, and darkens anything.
bool DarkensByRays(const std::vector<StageChoice>& stages);

/// Every stage with its parameters, ranges and defaults, as text.
std::string DescribeStages();

///@{
/// Adds the row of an option that sets a parameter of a stage, and returns it. `help` precedes the
/// range and the default; `read` converts the option's value to the parameter's.
vtkRelievoOption& AddOfStage(OptionRows& rows, std::vector<StageChoice>& stages,
  const std::string& use, const std::string& stage, const std::string& parameter,
  const std::string& help,
  const std::function<std::string(const std::string& word)>& read = nullptr);

/// Adds the row of an option that also switches the stage: its values are `off` and the choices of
/// the parameter, which replace @choices@ in the help.
vtkRelievoOption& AddSwitch(OptionRows& rows, std::vector<StageChoice>& stages,
  const std::string& name, const std::string& form, const std::string& stage,
  const std::string& parameter, const std::string& help);
///@}

///@{
/// The rows of --ambient, and of --deferred and --stage.
void AddAmbientOption(OptionRows& rows, std::vector<StageChoice>& stages);
void AddStageOptions(OptionRows& rows, std::vector<StageChoice>& stages);
///@}
}

#endif
