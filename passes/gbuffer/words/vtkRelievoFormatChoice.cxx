// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFormatChoice.h"

#include "vtkRelievoWordFormats.h"

#include <algorithm>
#include <iterator>

namespace
{
namespace Code = vtkRelievoWordFormats;

// Largest errors, rounded up, which the tests of formats check. In order of size; within a size,
// the cheaper format first.
struct Format
{
  int Code;
  double Error;
};
constexpr Format Normals[] = { // degrees
  { Code::NORMAL_OCT8, 0.96 }, { Code::NORMAL_OCT8_PRECISE, 0.65 }, { Code::NORMAL_RGB8, 0.4 },
  { Code::NORMAL_RGB10A2, 0.098 }, { Code::NORMAL_OCT16, 0.0038 },
  { Code::NORMAL_OCT16_PRECISE, 0.0026 }, { Code::NORMAL_FLOAT32, 1e-5 }
};
constexpr Format Depths[] = { // as a share of the depth
  { Code::DEPTH_16F, 4.9e-4 }, { Code::DEPTH_32F, 6e-8 }
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
bool vtkRelievoFormatChoice::IsNormalTolerance(double degrees)
{
  return IsTolerance(Normals, degrees, 180.0);
}

//------------------------------------------------------------------------------
bool vtkRelievoFormatChoice::IsDepthTolerance(double share)
{
  return IsTolerance(Depths, share, 1.0);
}

//------------------------------------------------------------------------------
int vtkRelievoFormatChoice::ChooseNormal(double degrees)
{
  return Choose(Normals, degrees);
}

//------------------------------------------------------------------------------
int vtkRelievoFormatChoice::ChooseDepth(double share)
{
  return Choose(Depths, share);
}
