// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a scene and writes the requested pictures, layers and reports: all of them or none.
 */
#ifndef WriteOutputs_h
#define WriteOutputs_h

#include "Outputs.h"
#include "SceneNames.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace reading
{
class Progress;
}

namespace scene
{
class Bands;
class StyledScene;
class Settings;
struct RenderOptions;

/// The options as they are, or with PNG files in place of a film where the program ffmpeg is
/// missing, with a note.
RenderOptions FollowProgram(RenderOptions options);

/// The frames of a sequence to draw, from the first to before the end.
struct FrameRange
{
  int First;
  int End;
  std::function<void(int frame)> OnWritten; ///< called after a frame's files are in place
};

/// The output files of the options; for a sequence, those of a frame. Throws UsageError or
/// WorkError for a place that cannot be written or is an input.
std::unique_ptr<Outputs> OpenOutputs(
  const RenderOptions& options, const std::vector<std::string>& inputs, int frame);

/// Draws the scene as set by the options and writes the files; in a sequence, each frame's files
/// are written before the next frame is drawn. `settings`: the source of the options, for the
/// record of a baseline. `bands`: of the renderer's window. `inputs`: all files read; no frame may
/// replace one. Returns the shadows' certificate as text if it was requested. Throws UsageError for
/// layers that the scene does not have, and WorkError.
std::string WriteOutputs(StyledScene& styled, const RenderOptions& options,
  const Settings& settings, const Bands& bands, const std::vector<std::string>& inputs,
  std::unique_ptr<Outputs> outputs, const FrameRange& range, Progress& progress);

/// Writes a film of PNG files. Throws UsageError or WorkError.
void WriteFilm(const std::string& path, const std::vector<std::string>& pictures,
  const std::array<int, 2>& size, double framesPerSecond);

/// Writes the scene, drawn in a window, as glTF (.glb). Throws UsageError or WorkError for a place
/// that cannot be written or is an input.
void WriteGltf(const StyledScene& styled, const std::string& path);
}

#endif
