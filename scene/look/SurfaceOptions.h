// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values of the options for surface maps, and checks of their combinations. All functions throw
 * UsageError.
 */
#ifndef SurfaceOptions_h
#define SurfaceOptions_h

#include "vtkRelievoParameterList.h"

#include <optional>
#include <set>
#include <string>

namespace scene
{
class Settings;
struct RenderOptions;

///@{
/// The named values of --material and --environment: the parameters of materials and environments
/// without those that have options of their own, with the defaults of scenes.
const vtkRelievoParameterList& GetMaterialValues();
const vtkRelievoParameterList& GetEnvironmentValues();
///@}

///@{
/// One of these values, in words: as given, or the default of scenes. Set "" removes it.
std::string GetSurfaceValue(const RenderOptions& options, const std::string& name);
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words);
///@}

/// The value's first condition (OnlyIf) that the other values do not meet.
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const RenderOptions& options, const vtkRelievoParameter& value);

/// Sets the file of --environment and keeps its other values; "" removes the option.
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation);

/// Removes the options that need --normal-map, --height-map or --environment when these are
/// missing, because they would be refused.
void DropIdleSurface(Settings& settings);

/// The choices of vtkRelievoMaterial's relief_method.
const std::vector<std::string>& GetReliefMethods();

void TakeMaterial(RenderOptions& options, const std::string& word);
void TakeHeightMap(RenderOptions& options, const std::string& word);
void TakeEnvironment(RenderOptions& options, const std::string& word);
void TakeReflectivity(RenderOptions& options, const std::string& word);

/// `given`: the names of the options on the command line.
void CheckSurfaceOptions(const RenderOptions& options, const std::set<std::string>& given);
}

#endif
