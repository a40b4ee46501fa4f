// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decodes the words of the G-buffer to normals and depths, by the formula files.
#ifndef vtkRelievoWordDecoder_h
#define vtkRelievoWordDecoder_h

#include "vtkRelievoFormulas.h" // for GLM

#include <cstdint>

struct vtkRelievoFrameCamera;

namespace vtkRelievoWordDecoder
{
// Eye space; `format` is one of vtkRelievoLayersStage::NormalFormats; the zero vector without a
// normal.
glm::vec3 DecodeNormal(const std::uint32_t* words, int format);

// World units; `format` is one of vtkRelievoLayersStage::DepthFormats; +infinity in the background.
double DecodeDepth(std::uint32_t word, int format, const vtkRelievoFrameCamera& view);

// Normal (xyz) and depth (w) of a texel of one of vtkRelievoLayersStage::NormalDepthFormats.
glm::vec4 DecodeNormalDepth(
  const std::uint32_t* words, int format, const vtkRelievoFrameCamera& view);
}

#endif
