// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The formats of normals and depths, as shaders/codes.glsl numbers them. vtkRelievoLayersStage
// gives users the same ones, and states the cost and the error of each.
#ifndef vtkRelievoWordFormats_h
#define vtkRelievoWordFormats_h

#include "codes.glsl"

namespace vtkRelievoWordFormats
{
enum Normals
{
  NORMAL_AUTO = 0,
  NORMAL_FLOAT32 = RELIEVO_NORMAL_FLOAT32,
  NORMAL_FLOAT16 = RELIEVO_NORMAL_FLOAT16,
  NORMAL_OCT16 = RELIEVO_NORMAL_OCT16,
  NORMAL_OCT16_PRECISE = RELIEVO_NORMAL_OCT16_PRECISE,
  NORMAL_OCT8 = RELIEVO_NORMAL_OCT8,
  NORMAL_OCT8_PRECISE = RELIEVO_NORMAL_OCT8_PRECISE,
  NORMAL_RGB10A2 = RELIEVO_NORMAL_RGB10A2,
  NORMAL_RGB8 = RELIEVO_NORMAL_RGB8
};

enum Depths
{
  DEPTH_32F = RELIEVO_DEPTH_32F,
  DEPTH_16F = RELIEVO_DEPTH_16F,
  DEPTH_WINDOW_Z24 = RELIEVO_DEPTH_WINDOW_Z24,
  DEPTH_REVERSED_32F = RELIEVO_DEPTH_REVERSED_32F
};

enum NormalDepths
{
  NORMAL_DEPTH_SEPARATE = RELIEVO_NORMAL_DEPTH_SEPARATE,
  NORMAL_DEPTH_RGBA8 = RELIEVO_NORMAL_DEPTH_RGBA8,
  NORMAL_DEPTH_RGBA16F = RELIEVO_NORMAL_DEPTH_RGBA16F,
  NORMAL_DEPTH_RGBA32F = RELIEVO_NORMAL_DEPTH_RGBA32F
};
}

#endif
