// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNormalAngles.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace relievo::compare
{
//------------------------------------------------------------------------------
double NormalAngles::Get(std::size_t pixel) const
{
  const Layer* before = FramePair::Find(this->Frames.A.Surface, "normal");
  const Layer* after = FramePair::Find(this->Frames.B.Surface, "normal");
  if (!before || !after || before->Components != 3 || after->Components != 3)
  {
    return 0.0;
  }
  const float* a = before->Values.data() + 3 * pixel;
  const float* b = after->Values.data() + 3 * pixel;
  const bool isEqual = FramePair::IsEqual(a[0], b[0]) && FramePair::IsEqual(a[1], b[1]) &&
    FramePair::IsEqual(a[2], b[2]);
  const double angle = isEqual ? 0.0 : FramePair::GetAngle(a, b);
  const auto isZero = [](const float* v) { return v[0] == 0.f && v[1] == 0.f && v[2] == 0.f; };
  return std::isnan(angle) || isZero(a) != isZero(b) ? 180.0 : angle;
}

//------------------------------------------------------------------------------
bool NormalAngles::IsMapped(int a) const
{
  const int b = this->Objects.GetAfter(a);
  const auto find = [](const Frame& frame, int object) {
    return object >= 0 && object < static_cast<int>(frame.Objects.size())
      ? &frame.Objects[static_cast<std::size_t>(object)]
      : nullptr;
  };
  const Object* from = find(this->Frames.A, a);
  const Object* to = find(this->Frames.B, b);
  return from && to && from->HasNormalMap && to->HasNormalMap &&
    (from->NormalMap == to->NormalMap || from->NormalMap.empty() || to->NormalMap.empty());
}

//------------------------------------------------------------------------------
// Whether the filtering of a normal map explains the angle between the pixel's normals: OpenGL may
// blend texels by weights of 8 bits and round the three components of the result to 8 bits. The
// result then lies between the texels around, which the neighbours show, but for the rounding.
bool NormalAngles::IsTexelRounded(std::size_t pixel, double angle) const
{
  const double step = this->Bounds.ColorLevels / 127.5; // components are from -1 to 1
  if (angle > vtkMath::DegreesFromRadians(std::sqrt(3.0) * step))
  {
    return false;
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (!this->Frames.IsBetween(pixel, step, [c](const Frame& frame, std::size_t at) {
          return frame.Surface.at("normal").Values[3 * at + c];
        }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the angle between the pixel's normals explains its colours: these lie between the colours
// around it, extended by twice as much as they change towards those for such an angle.
bool NormalAngles::Explains(std::size_t pixel, double angle) const
{
  for (int c = 0; c < this->Frames.CountLevels(); ++c)
  {
    double most = 0.0;
    for (const Frame* frame : { &this->Frames.A, &this->Frames.B })
    {
      const float* normals = frame->Surface.at("normal").Values.data();
      this->Frames.ForNeighbours(pixel, [&](std::size_t near) {
        const double turn = FramePair::GetAngle(normals + 3 * pixel, normals + 3 * near);
        const double change =
          std::abs(double(frame->Level(near, c)) - double(frame->Level(pixel, c)));
        most = std::max(most, change * angle / std::max(angle, turn));
      });
    }
    if (!this->Frames.IsBetween(pixel, this->Bounds.ColorLevels + 2.0 * most,
          [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); }))
    {
      return false;
    }
  }
  return true;
}
}
