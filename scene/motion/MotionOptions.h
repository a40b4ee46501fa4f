// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --turntable, --camera-path, --fps, --video and --resume: frames of a moving camera, and films.
 */
#ifndef MotionOptions_h
#define MotionOptions_h

#include "SceneNames.h"

#include <string>

namespace scene
{
struct MotionChoice
{
  int Turntable = 0;             ///< frames of one turn; 0: no turn
  std::string Path;              ///< file of a camera's path; empty: none
  double FramesPerSecond = 25.0; ///< of films and of a camera's path
  std::string Video;             ///< the film; empty: none
  bool Resume = false;           ///< whether frames whose files exist are kept

  bool MovesCamera() const { return this->Turntable > 0 || !this->Path.empty(); }
};

/// The rows of these options.
void AddMotionOptions(OptionRows& rows, MotionChoice& motion);
}

#endif
