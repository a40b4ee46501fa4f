// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWordDecoder.h"

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoWordFormats.h"

#include <cmath>

//------------------------------------------------------------------------------
glm::vec3 vtkRelievoWordDecoder::DecodeNormal(const std::uint32_t* words, int format)
{
  using namespace relievo::f32;
  switch (format)
  {
    case vtkRelievoWordFormats::NORMAL_FLOAT32:
      return relievoUnpackNormalFloat(glm::uvec3(words[0], words[1], words[2]));
    case vtkRelievoWordFormats::NORMAL_FLOAT16:
      return relievoUnpackNormalHalf(glm::uvec2(words[0], words[1]));
    case vtkRelievoWordFormats::NORMAL_OCT16:
    case vtkRelievoWordFormats::NORMAL_OCT16_PRECISE:
      return relievoUnpackNormalOct16(words[0]);
    case vtkRelievoWordFormats::NORMAL_OCT8:
    case vtkRelievoWordFormats::NORMAL_OCT8_PRECISE:
      return relievoUnpackNormalOct8(words[0]);
    case vtkRelievoWordFormats::NORMAL_RGB10A2:
      return relievoUnpackNormalUnorm10(words[0]);
    default:
      return relievoUnpackNormalUnorm8(words[0]);
  }
}

//------------------------------------------------------------------------------
double vtkRelievoWordDecoder::DecodeDepth(
  std::uint32_t word, int format, const vtkRelievoFrameCamera& view)
{
  using namespace relievo::f64;
  switch (format)
  {
    case vtkRelievoWordFormats::DEPTH_16F:
      return relievoUnpackDepth16F(
        word, relievo::f32::relievoDepth16FScale(static_cast<float>(view.Far)));
    case vtkRelievoWordFormats::DEPTH_WINDOW_Z24:
    {
      const double z = relievoUnpackWindowZ24(word);
      return view.Parallel ? relievoParallelDepth(z, view.Near, view.Far)
                           : relievoPerspectiveDepth(z, view.Near, view.Far);
    }
    case vtkRelievoWordFormats::DEPTH_REVERSED_32F:
    {
      const double z = relievoUnpackDepth32F(word);
      if (std::isinf(z))
      {
        return -z;
      }
      return view.Parallel ? relievoParallelDepthFromReversed(z, view.Near, view.Far)
                           : relievoPerspectiveDepthFromReversed(z, view.Near, view.Far);
    }
    default:
      return relievoUnpackDepth32F(word);
  }
}

//------------------------------------------------------------------------------
glm::vec4 vtkRelievoWordDecoder::DecodeNormalDepth(
  const std::uint32_t* words, int format, const vtkRelievoFrameCamera& view)
{
  using namespace relievo::f32;
  const float zNear = static_cast<float>(view.Near);
  const float zFar = static_cast<float>(view.Far);
  switch (format)
  {
    case vtkRelievoWordFormats::NORMAL_DEPTH_RGBA32F:
      return relievoUnpackNormalDepth32F(glm::uvec4(words[0], words[1], words[2], words[3]));
    case vtkRelievoWordFormats::NORMAL_DEPTH_RGBA16F:
      return relievoUnpackNormalDepth16F(
        glm::uvec2(words[0], words[1]), relievoDepth16FScale(zFar));
    default:
      return relievoUnpackNormalDepth8(words[0], zNear, zFar);
  }
}
