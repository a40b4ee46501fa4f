// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words of the G-buffer back to normals and depths, by the formula files.
#ifndef vtkRelievoWordDecoder_h
#define vtkRelievoWordDecoder_h

#include "vtkRelievoFormulas.h" // for GLM

#include <cstdint>

struct vtkRelievoFrameCamera;

namespace vtkRelievoWordDecoder
{
// Eye space, by vtkRelievoLayersStage::NormalFormats; the zero vector where there is none.
glm::vec3 DecodeNormal(const std::uint32_t* words, int format);

// World units, by vtkRelievoLayersStage::DepthFormats; +infinity where nothing is.
double DecodeDepth(std::uint32_t word, int format, const vtkRelievoFrameCamera& view);

// Normal (xyz) and depth (w) of one texel, by vtkRelievoLayersStage::NormalDepthFormats.
glm::vec4 DecodeNormalDepth(
  const std::uint32_t* words, int format, const vtkRelievoFrameCamera& view);
}

#endif
