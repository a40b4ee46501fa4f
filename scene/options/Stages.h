// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Stages of the frame as the command line asks for them: --stage NAME[:PARAMETER=VALUE,...], and
 * options of their own. Which there are, and what they take, the stages say themselves.
 */
#ifndef Stages_h
#define Stages_h

#include <string>
#include <utility>
#include <vector>

class vtkRelievoPass;

namespace scene
{
struct StageChoice
{
  std::string Name;
  std::vector<std::pair<std::string, std::string>> Parameters; ///< name and value, as given
  std::string Option = "--stage";                              ///< that asks for it
};

/// Asks for a stage, by an option of its own, behind what was asked for before.
StageChoice& AddStage(
  std::vector<StageChoice>& stages, const std::string& name, const std::string& option);

/// The word behind --stage. A value goes on over commas up to the next PARAMETER=. Of stages that
/// serve when they are off `visible` is an older word for `enabled`, and the name alone is that.
StageChoice ParseStage(const std::string& word);

/// The last value of a parameter among the choices, or among those of one option; nullptr: none.
const std::string* FindStageChoice(const std::vector<StageChoice>& stages, const std::string& name,
  const std::string& parameter, const std::string& option = "");

/// A frame as it is at first, for what its stages say of themselves.
vtkRelievoPass* GetNewFrame();

/// Throws UsageError if a frame has no such stage, or if it does not take a parameter's value.
void CheckStages(const std::vector<StageChoice>& stages);

/// Switches the stages on, with their parameters; those that serve when they are off by
/// `enabled=on` alone.
void SetStages(vtkRelievoPass* pass, const std::vector<StageChoice>& stages);

/// Every stage with its parameters, their ranges and defaults, for people to read.
std::string DescribeStages();
}

#endif
