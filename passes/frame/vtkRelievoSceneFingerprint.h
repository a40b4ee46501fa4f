// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything that a frame's picture depends on, to see whether two frames are of the same: camera,
// size, lights, props with what they draw, and the settings of stages. Texts and other 2D actors,
// which are drawn over the picture, are not part of it.
#ifndef vtkRelievoSceneFingerprint_h
#define vtkRelievoSceneFingerprint_h

#include <cstdint>
#include <vector>

class vtkRelievoFrameContext;
class vtkRelievoStage;

namespace vtkRelievoSceneFingerprint
{
std::vector<std::uint64_t> Take(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);
}

#endif
