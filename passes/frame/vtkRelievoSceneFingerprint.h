// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything that a frame's picture depends on, to see whether two frames are of the same: camera,
// size, lights, props with what they draw, and the settings of stages. Texts and other 2D actors,
// which are drawn over the picture, are not part of it.
#ifndef vtkRelievoSceneFingerprint_h
#define vtkRelievoSceneFingerprint_h

#include "vtkRelievoRendererChanges.h"

#include <cstdint>
#include <vector>

class vtkRelievoFrameContext;
class vtkRelievoStage;

class vtkRelievoSceneFingerprint
{
public:
  // Keeps what the frame is of now.
  void Take(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Whether the frame is of what was kept.
  bool IsOf(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Nothing is kept, and no frame is of it.
  void Clear() { this->Kept = State(); }

private:
  struct State
  {
    std::vector<std::uint64_t> Values;
    std::vector<double> Projection; // a vtkWindowToImageFilter's has angles of single precision
  };
  // What is known without the props, which comes first in a state's values.
  std::vector<std::uint64_t> MakeFirst(const vtkRelievoFrameContext& context);
  State Make(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  State Kept;
  vtkRelievoRendererChanges Changes;
};

#endif
