// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoStageRegistry.h"

#include "vtkRelievoStage.h"

#include <algorithm>
#include <map>
#include <utility>

namespace
{
// Slot and name: the order of stages in frames.
using Key = std::pair<int, std::string>;

std::map<Key, vtkRelievoStageRegistry::Maker>& GetMakers()
{
  static std::map<Key, vtkRelievoStageRegistry::Maker> makers;
  return makers;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoStageRegistry::Add(Maker maker)
{
  const auto stage = vtkSmartPointer<vtkRelievoStage>::Take(maker());
  const vtkRelievoStageDescription& description = stage->GetDescription();
  auto& makers = GetMakers();
  const bool there = std::any_of(makers.begin(), makers.end(),
    [&description](const auto& known) { return known.first.second == description.Name; });
  if (there || description.Name.empty())
  {
    vtkGenericWarningMacro("A stage cannot be registered as '"
      << description.Name << "', " << (there ? "which is another stage's name" : "without a name")
      << "; give it a name of its own in Describe().");
    return false;
  }
  makers[Key(description.Slot, description.Name)] = maker;
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoStage>> vtkRelievoStageRegistry::MakeAll()
{
  std::vector<vtkSmartPointer<vtkRelievoStage>> stages;
  for (const auto& known : GetMakers())
  {
    stages.push_back(vtkSmartPointer<vtkRelievoStage>::Take(known.second()));
  }
  return stages;
}
