// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values of the options for surface maps, and checks of their combinations. All functions throw
 * UsageError.
 */
#ifndef SurfaceOptions_h
#define SurfaceOptions_h

#include "Arguments.h"
#include "LookNames.h"
#include "Values.h"

#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

#include <optional>
#include <string>

namespace look
{
/// Methods for generating missing texture coordinates.
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
  NamedWords Material;                   ///< other values, as given
  std::optional<Mapping> TextureMapping; ///< none: a box, with a note
  std::string Environment;               ///< file; empty: none
  double EnvironmentRotation = 0.0;      ///< degrees about the up axis
  NamedWords EnvironmentValues;          ///< other values, as given
  double Reflectivity = 0.04;            ///< share of the environment's light that is mirrored
  double Roughness = 0.2;                ///< of the mirror
  bool Skybox = false;
  bool FindsIntensity = false; ///< of the environment, where it is very bright or dark
  bool Shadowed = false;       ///< the picture shows shadows, which relief then casts on itself

  /// Whether images are placed by texture coordinates.
  bool IsMapped() const { return !this->NormalMap.empty() || !this->HeightMap.empty(); }
};

///@{
/// The named values of --material and --environment: the parameters of materials and environments
/// without those that have options of their own, with the defaults of scenes.
const vtkRelievoParameterList& GetMaterialValues();
const vtkRelievoParameterList& GetEnvironmentValues();
///@}

/// One of these values, in words: as given, or the default of scenes.
std::string GetSurfaceValue(const SurfaceChoice& surface, const std::string& name);

/// The value's first condition (OnlyIf) that the other values do not meet.
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const SurfaceChoice& surface, const vtkRelievoParameter& value);

/// The choices of vtkRelievoMaterial's relief_method.
const std::vector<std::string>& GetReliefMethods();

void TakeMaterial(SurfaceChoice& surface, const std::string& word);
void TakeHeightMap(SurfaceChoice& surface, const std::string& word);
void TakeEnvironment(SurfaceChoice& surface, const std::string& word);
void TakeReflectivity(SurfaceChoice& surface, const std::string& word);

/// `given`: the names of the options on the command line.
void CheckSurfaceOptions(const SurfaceChoice& surface, const GivenWords& given);
}

#endif
