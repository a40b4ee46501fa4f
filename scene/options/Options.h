// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The words of `relievo render` as a struct: the scene's contents and the outputs. Parsing reads no
 * file; it throws UsageError.
 */
#ifndef Options_h
#define Options_h

#include "LightOptions.h"
#include "LookOptions.h"
#include "ModelOptions.h"
#include "Points.h"
#include "Stages.h"
#include "VolumeImages.h"
#include "vtkRelievoOption.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace scene
{
/// FromFile: phong, except that a glTF file keeps the shading of its own materials.
enum class Shading
{
  FromFile,
  Flat,
  Gouraud,
  Phong,
  PBR
};

enum class Shadows
{
  Off,
  Map,
  Forward,
  Warped,
  Exact
};

/// Methods for generating missing texture coordinates.
enum class Mapping
{
  Box,
  Plane,
  Sphere
};

/// Pixels or texels per direction. OpenGL's own limit, which may be lower, is queried later.
constexpr int LargestSize = 16384;

/// Maximum number of rays for --certify.
constexpr int MostRays = 100000000;

struct CameraPlace
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  std::array<double, 3> ViewUp;
};

struct RenderOptions
{
  std::vector<std::string> Files;
  std::vector<std::string> AllowedFolders;       ///< of referenced files, besides the files' own
  std::array<int, 2> Size = { 1024, 768 };       ///< width, height in pixels
  bool IsSized = false;                          ///< whether --size was given
  std::string Lens;                              ///< in place of a pinhole; empty: none
  std::optional<CameraPlace> Camera;             ///< none: fitted to the scene
  std::optional<std::array<double, 3>> ViewFrom; ///< right, up and near; none: along an axis
  std::optional<double> ViewAngle;               ///< full vertical angle, degrees
  std::optional<double> ParallelScale;           ///< half the height, world units
  std::optional<std::array<double, 2>> Clip;
  ImageChoice Image; ///< how images with depth are shown
  Shading ShadingKind = Shading::FromFile;
  std::string Preset; ///< of lights, shadows, ground, background and view
  LookChoice Look;
  ModelChoice Model;               ///< pose and animation of models with bones
  std::vector<LightChoice> Lights; ///< none: the file's, or VTK's headlight
  std::optional<double> Fill;      ///< share of the preset's weak lights; none: the preset has none
  bool YieldsToFile = false;       ///< the file's lights, if any, replace these
  Shadows ShadowMethod = Shadows::Off;
  std::optional<int> Certify;            ///< rays
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
  int UpAxis = 1;                   ///< the world's up axis: 0, 1, 2 for x, y, z
  bool FindsUp = false;             ///< replaces UpAxis by the scene's own
  std::optional<bool> Ground;       ///< whether to add one below the scene; none: no
  std::vector<PointsChoice> Points; ///< for stages that draw points
  std::vector<StageChoice> Stages;  ///< in the order given
  bool HDR = false;                 ///< EXR colour unclamped
  bool Transparent = false;         ///< PNG without background
  std::vector<std::string> Layers;  ///< each once; of the EXR besides its colour
  std::string PNG, EXR, Report;     ///< empty: not requested
};

/// The command `render`, whose options fill `options`.
vtkRelievoCommand DescribeRender(RenderOptions& options);

/// The command's description, for lookup.
const vtkRelievoCommand& GetRenderCommand();

/// Parses files and options in the words of `relievo render`; files may follow later.
RenderOptions ParseOptions(const std::vector<std::string>& words);

/// Throws UsageError unless there is a file and an output.
void CheckOutputs(const RenderOptions& options);
}

#endif
