// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything that a frame's picture depends on, to compare frames: camera, size, lights, props with
// their data, and the settings of stages. Texts and other 2D actors, which are drawn over the
// picture, are excluded.
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
  // Stores the frame's present state.
  void Take(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Whether the frame matches the stored state.
  bool IsOf(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Clears the stored state, so that no frame matches.
  void Clear() { this->Stored = State(); }

private:
  struct State
  {
    std::vector<std::uint64_t> Values;
    std::vector<double> Projection; // a vtkWindowToImageFilter's has single-precision angles
  };
  // The values that need no props; they come first in a state's values.
  std::vector<std::uint64_t> MakeFirst(const vtkRelievoFrameContext& context);
  State Make(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  State Stored;
  vtkRelievoRendererChanges Changes;
};

#endif
