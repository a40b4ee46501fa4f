// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Formats by what they may err: the smallest that is accurate enough.
#include "vtkRelievoGBufferPass.h"

#include <algorithm>
#include <iterator>

namespace
{
// Largest errors, rounded up: what the tests of formats hold them to (docs/choosing-formats.md).
// From small to large; of the same size, the cheaper one first.
struct Format
{
  int Code;
  double Error;
};
using Pass = vtkRelievoGBufferPass;
constexpr Format Normals[] = { // degrees
  { Pass::NORMAL_OCT8, 0.96 }, { Pass::NORMAL_OCT8_PRECISE, 0.65 }, { Pass::NORMAL_RGB8, 0.4 },
  { Pass::NORMAL_RGB10A2, 0.098 }, { Pass::NORMAL_OCT16, 0.0038 },
  { Pass::NORMAL_OCT16_PRECISE, 0.0026 }, { Pass::NORMAL_FLOAT32, 1e-5 }
};
constexpr Format Depths[] = { // of the depth
  { Pass::DEPTH_16F, 4.9e-4 }, { Pass::DEPTH_32F, 6e-8 }
};

template <typename Formats>
int Choose(const Formats& formats, double tolerance)
{
  const auto first = std::find_if(std::begin(formats), std::end(formats),
    [tolerance](const Format& format) { return format.Error <= tolerance; });
  return first == std::end(formats) ? (std::end(formats) - 1)->Code : first->Code;
}

template <typename Formats>
bool IsTolerance(const Formats& formats, double tolerance, double most)
{
  return tolerance == 0.0 || (tolerance >= (std::end(formats) - 1)->Error && tolerance <= most);
}
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::SetNormalTolerance(double degrees)
{
  if (!IsTolerance(Normals, degrees, 180.0))
  {
    vtkErrorMacro("SetNormalTolerance was given "
      << degrees << "; give it 1e-5, the error of the most accurate format, to 180 degrees, or 0 "
      << "for the format that is set.");
    return;
  }
  if (this->NormalTolerance != degrees)
  {
    this->NormalTolerance = degrees;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::SetDepthTolerance(double share)
{
  if (!IsTolerance(Depths, share, 1.0))
  {
    vtkErrorMacro("SetDepthTolerance was given "
      << share << "; give it 6e-8, the error of the most accurate format, to 1, as a share of the "
      << "depth, or 0 for the format that is set.");
    return;
  }
  if (this->DepthTolerance != share)
  {
    this->DepthTolerance = share;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferPass::GetNormalFormatUsed()
{
  return this->NormalTolerance > 0.0 ? Choose(Normals, this->NormalTolerance) : this->NormalFormat;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferPass::GetDepthFormatUsed()
{
  return this->DepthTolerance > 0.0 ? Choose(Depths, this->DepthTolerance) : this->DepthFormat;
}
