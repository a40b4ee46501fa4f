// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of the options that say what surfaces wear, and what of them goes together. All throw
 * UsageError.
 */
#ifndef SurfaceOptions_h
#define SurfaceOptions_h

#include "Values.h"

#include "vtkRelievoParameterList.h"

#include <optional>
#include <set>
#include <string>

namespace scene
{
/// How meshes without texture coordinates get some.
enum class Mapping
{
  Box,
  Plane,
  Sphere
};

struct SurfaceChoice
{
  std::string NormalMap, HeightMap;      ///< files; empty: none
  std::optional<double> HeightScale;     ///< depth of the relief, world units
  std::string ReliefMethod = "relief";   ///< a word of vtkRelievoMaterial's relief_method
  NamedWords Material;                   ///< its other values, as given
  std::optional<Mapping> TextureMapping; ///< none: as a box, with a note
  std::string Environment;               ///< file; empty: none
  double EnvironmentRotation = 0.0;      ///< degrees about the up axis
  NamedWords EnvironmentValues;          ///< its other values, as given
  double Reflectivity = 0.04;            ///< share of the environment's light that is mirrored
  double Roughness = 0.2;                ///< of that mirror
  bool Skybox = false;
  bool Shadowed = false; ///< the picture shows shadows, which relief then casts on itself

  /// Whether images are placed by texture coordinates.
  bool IsMapped() const { return !this->NormalMap.empty() || !this->HeightMap.empty(); }
};

///@{
/// What --material and --environment take by name: what materials and environments say of their
/// values, without those that have options of their own; defaults are those of scenes.
const vtkRelievoParameterList& GetMaterialValues();
const vtkRelievoParameterList& GetEnvironmentValues();
///@}

/// One of these values, in words: as given, or as scenes have it.
std::string GetSurfaceValue(const SurfaceChoice& surface, const std::string& name);

/// The first condition for a value to have an effect that does not hold beside the others.
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const SurfaceChoice& surface, const vtkRelievoParameter& value);

/// The words of vtkRelievoMaterial's relief_method.
const std::vector<std::string>& GetReliefMethods();

void TakeMaterial(SurfaceChoice& surface, const std::string& word);
void TakeHeightMap(SurfaceChoice& surface, const std::string& word);
void TakeEnvironment(SurfaceChoice& surface, const std::string& word);
void TakeReflectivity(SurfaceChoice& surface, const std::string& word);

/// `given`: the names of the options that were said.
void CheckSurfaceOptions(const SurfaceChoice& surface, const std::set<std::string>& given);
}

#endif
