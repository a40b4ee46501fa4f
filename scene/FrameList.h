// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frames of a sequence: their times, views and file names.
 */
#ifndef FrameList_h
#define FrameList_h

#include "CameraOptions.h"
#include "SceneNames.h"

#include <optional>
#include <vector>

namespace scene
{
struct RenderOptions;
struct Scene;

/// The number of frames of a sequence. Throws UsageError or FileError for the file of a camera's
/// path.
int CountFrames(const RenderOptions& options);

/// The options for one frame: its time and its file names; those given if there is no sequence.
RenderOptions GetFrameOptions(const RenderOptions& options, int frame);

class FrameList
{
public:
  /// The scene must have the options' camera: a turn begins with it. Throws UsageError or FileError
  /// for the file of a camera's path.
  FrameList(const Scene& scene, const RenderOptions& options);

  int GetCount() const { return this->Count; } ///< 0: no sequence

  /// A frame's options, with its view.
  RenderOptions Get(const RenderOptions& options, int frame) const;

private:
  int Count = 0;
  std::vector<CameraPlace> Views; // empty: the camera rests
};
}

#endif
