// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a scene and writes what is asked for: pictures, layers, reports; all of them or none.
 */
#ifndef WriteOutputs_h
#define WriteOutputs_h

#include "Outputs.h"

#include <memory>
#include <string>
#include <vector>

namespace scene
{
class DressedScene;
class Progress;
class Settings;
struct RenderOptions;

/// The files that the options ask for; of a sequence, those of its first frame. Throws UsageError
/// or WorkError for a place that cannot be written, or that is one of the inputs.
std::unique_ptr<Outputs> OpenOutputs(
  const RenderOptions& options, const std::vector<std::string>& inputs);

/// Draws the scene, which is shown by the options, and writes the files; of a sequence, each
/// frame's before the next one is drawn. `inputs`: all files that were read, for none to be
/// replaced, be it by the last frame. `settings`: what the options were made of, for the record of
/// a baseline. Returns the shadows' certificate in words, if it is
/// asked for. Throws UsageError for layers that the scene does not have, WorkError.
std::string WriteOutputs(DressedScene& dressed, const RenderOptions& options,
  const Settings& settings, const std::vector<std::string>& inputs,
  std::unique_ptr<Outputs> outputs, Progress& progress);
}

#endif
