// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of the options that say what surfaces wear, and what of them goes together. All throw
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
/// What --material and --environment take by name: what materials and environments say of their
/// values, without those that have options of their own; defaults are those of scenes.
const vtkRelievoParameterList& GetMaterialValues();
const vtkRelievoParameterList& GetEnvironmentValues();
///@}

///@{
/// One of these values, in words: as given, or as scenes have it. Set "" takes it back.
std::string GetSurfaceValue(const RenderOptions& options, const std::string& name);
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words);
///@}

/// The first condition for a value to have an effect that does not hold beside the others.
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const RenderOptions& options, const vtkRelievoParameter& value);

/// The word of --environment, whose other values stay; "" takes it back.
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation);

/// Takes back what --normal-map, --height-map and --environment were needed for, if they are gone:
/// it would be refused.
void DropIdleSurface(Settings& settings);

/// The words of vtkRelievoMaterial's relief_method.
const std::vector<std::string>& GetReliefMethods();

void TakeMaterial(RenderOptions& options, const std::string& word);
void TakeHeightMap(RenderOptions& options, const std::string& word);
void TakeEnvironment(RenderOptions& options, const std::string& word);
void TakeReflectivity(RenderOptions& options, const std::string& word);

/// `given`: the names of the options that were said.
void CheckSurfaceOptions(const RenderOptions& options, const std::set<std::string>& given);
}

#endif
