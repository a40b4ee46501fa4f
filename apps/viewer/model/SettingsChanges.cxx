// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How settings differ, and what differs taken over to others.
#include "Options.h"
#include "Settings.h"

namespace viewer
{
//------------------------------------------------------------------------------
std::set<std::string> Settings::GetChanges(const Settings& other) const
{
  std::set<std::string> changes;
  if (this->Files != other.Files)
  {
    changes.insert("");
  }
  for (const cli::KnownOption& option : cli::GetRenderOptions())
  {
    if (this->GetAll(option.Name) != other.GetAll(option.Name))
    {
      changes.insert(option.Name);
    }
  }
  std::map<std::string, Parameters> stages = this->Stages;
  stages.insert(other.Stages.begin(), other.Stages.end());
  for (const auto& stage : stages)
  {
    const std::string& name = stage.first;
    if (this->IsStageAsked(name) != other.IsStageAsked(name))
    {
      changes.insert(name + ":");
    }
    for (const Settings* each : { this, &other })
    {
      const auto found = each->Stages.find(name);
      for (const auto& parameter : found == each->Stages.end() ? Parameters() : found->second)
      {
        const std::string* mine = this->Find(name, parameter.first);
        const std::string* others = other.Find(name, parameter.first);
        if (!mine || !others || *mine != *others)
        {
          changes.insert(name + ":" + parameter.first);
        }
      }
    }
  }
  return changes;
}

//------------------------------------------------------------------------------
void Settings::TakeChanges(const Settings& before, const Settings& after)
{
  for (const std::string& change : before.GetChanges(after))
  {
    const std::size_t colon = change.find(':');
    if (change.empty())
    {
      continue; // files are each one's own
    }
    if (colon == std::string::npos)
    {
      this->SetAll(change, after.GetAll(change));
      continue;
    }
    const std::string stage = change.substr(0, colon), parameter = change.substr(colon + 1);
    if (parameter.empty() || !after.IsStageAsked(stage))
    {
      this->AskStage(stage, after.IsStageAsked(stage));
    }
    else
    {
      const std::string* value = after.Find(stage, parameter);
      this->SetGiven(stage, parameter, value ? *value : GetStandard(stage, parameter));
    }
  }
}
}
