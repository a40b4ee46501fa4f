// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a scene shows and what is written of it: the words of `relievo render` as a struct. Parsing
 * touches no file; it throws UsageError.
 */
#ifndef Options_h
#define Options_h

#include "CameraOptions.h"
#include "LightOptions.h"
#include "LookOptions.h"
#include "ModelOptions.h"
#include "PointOptions.h"
#include "Stages.h"
#include "SurfaceOptions.h"
#include "VolumeImages.h"
#include "vtkRelievoOption.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace scene
{
enum class Shadows
{
  Off,
  Map,
  Forward,
  Warped,
  Exact
};

/// Pixels or texels each way. OpenGL's own limit, which may be lower, is asked when there is one.
constexpr int LargestSize = 16384;

/// Rays of --certify.
constexpr int MostRays = 100000000;

struct RenderOptions
{
  std::vector<std::string> Files;
  std::vector<std::string> AllowedFolders; ///< of what files name, besides their own folders
  std::array<int, 2> Size = { 1024, 768 }; ///< width, height in pixels
  bool IsSized = false;                    ///< the size was given
  std::string Lens;                        ///< in place of a pinhole; empty: none
  CameraChoice View;
  ImageChoice Image; ///< how images with depth are shown
  Shading ShadingKind = Shading::FromFile;
  std::string Preset; ///< of lights, shadows, ground, background and view
  LookChoice Look;
  ModelChoice Model;               ///< what models with bones show
  std::vector<LightChoice> Lights; ///< none: the file's, or VTK's headlight
  std::optional<double> Fill;      ///< share of the preset's weak lights; none: it has no such
  bool YieldsToFile = false;       ///< if the file has lights, they are in the place of these
  Shadows ShadowMethod = Shadows::Off;
  std::optional<int> Certify;       ///< rays
  SurfaceChoice Surface;            ///< what surfaces wear
  int UpAxis = 1;                   ///< of the world: 0, 1, 2 for x, y, z
  bool FindsUp = false;             ///< the scene's own is taken in its place
  std::optional<bool> Ground;       ///< whether one lies below the scene; none: not
  std::vector<PointsChoice> Points; ///< for stages that draw points
  std::vector<StageChoice> Stages;  ///< of the frame, as given
  bool HDR = false;                 ///< the colour of the EXR unclamped
  bool Transparent = false;         ///< the PNG has no background
  std::vector<std::string> Layers;  ///< each once; those of the EXR beside its colour
  std::string PNG, EXR, Report;     ///< empty: not asked for
  std::string Baseline;             ///< an EXR to compare with; empty: not asked for
};

/// The command `render`, whose options fill these.
vtkRelievoCommand DescribeRender(RenderOptions& options);

/// What there is to know of it.
const vtkRelievoCommand& GetRenderCommand();

/// Files and options in the words of `relievo render`; files may come later.
RenderOptions ParseOptions(const std::vector<std::string>& words);

/// Throws UsageError unless there is a file, and something to write.
void CheckOutputs(const RenderOptions& options);
}

#endif
