// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The words of `relievo render` as a struct: the scene's contents and the outputs. Parsing reads no
 * file; it throws UsageError.
 */
#ifndef Options_h
#define Options_h

#include "Arguments.h"
#include "CameraOptions.h"
#include "LightOptions.h"
#include "LookOptions.h"
#include "ModelOptions.h"
#include "MotionOptions.h"
#include "PointOptions.h"
#include "SceneNames.h"
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
/// Pixels or texels per direction. OpenGL's own limit, which may be lower, is queried later.
constexpr int LargestSize = 16384;

struct RenderOptions
{
  GivenWords Given;     ///< flags, and values that are read as words, have no member
  GivenNumbers Numbers; ///< nor have numbers that one place uses
  std::vector<std::string> Files;
  std::vector<std::string> AllowedFolders; ///< of referenced files, besides the files' own
  std::array<int, 2> Size = { 1024, 768 }; ///< width, height in pixels
  bool IsSized = false;                    ///< whether --size was given
  std::string Lens;                        ///< in place of a pinhole; empty: none
  CameraChoice View;
  ImageChoice Image; ///< how images with depth are shown
  Shading ShadingKind = Shading::FromFile;
  std::string Preset; ///< of lights, shadows, ground, background and view
  LookChoice Look;
  ModelChoice Model;               ///< pose and animation of models with bones
  MotionChoice Motion;             ///< of the camera, and films
  std::vector<LightChoice> Lights; ///< none: the file's, or VTK's headlight
  std::optional<double> Fill;      ///< share of the preset's weak lights; none: the preset has none
  bool YieldsToFile = false;       ///< the file's lights, if any, replace these
  SurfaceChoice Surface;           ///< maps and environment of surfaces
  int UpAxis = 1;                  ///< the world's up axis: 0, 1, 2 for x, y, z
  bool FindsUp = false;            ///< replaces UpAxis by the scene's own
  std::optional<bool> Ground;      ///< whether to add one below the scene; none: no
  std::vector<PointsChoice> Points; ///< for stages that draw points
  std::vector<StageChoice> Stages;  ///< in the order given
  std::vector<std::string> Layers;  ///< each once; of the EXR besides its colour
  std::string PNG, EXR, Report;     ///< empty: not requested
  std::string Baseline;             ///< an EXR to compare with; empty: not requested
  std::string Gltf;                 ///< a .glb; empty: not requested

  bool Has(const std::string& option) const { return this->Given.count(option) > 0; }

  /// The word of an option; "" if it is not given.
  std::string GetWord(const std::string& option) const
  {
    const auto found = this->Given.find(option);
    return found == this->Given.end() ? "" : found->second;
  }

  bool WantsPicture() const { return !this->PNG.empty() || !this->Motion.Video.empty(); }
};

/// The command `render`, whose options fill `options`.
vtkRelievoCommand DescribeRender(RenderOptions& options);

/// The command's description, for lookup.
const vtkRelievoCommand& GetRenderCommand();

/// Whether an option that switches a stage made the request, such as --shadows.
bool IsOfSwitch(const StageChoice& choice);

/// Parses files and options in the words of `relievo render`; files may follow later.
RenderOptions ParseOptions(const std::vector<std::string>& words);
}

#endif
