// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Turntable.h"

#include "FittedView.h"
#include "Triples.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace look
{
namespace
{
struct Axes
{
  std::size_t Up, First, Second; // First x Second = Up

  explicit Axes(int up)
    : Up(static_cast<std::size_t>(up))
    , First((this->Up + 1) % 3)
    , Second((this->Up + 2) % 3)
  {
  }
};
}

//------------------------------------------------------------------------------
CameraPlace FitTurn(vtkRenderer* renderer, const CameraPlace& view, int up, const double bounds[6])
{
  const Axes axes(up);
  std::array<double, 3> half{};
  CameraPlace fitted = view;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    fitted.FocalPoint[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    half[axis] = 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  std::array<double, 3> towards = Minus(view.Position, view.FocalPoint);
  vtkMath::Normalize(towards.data());
  // The box turns within a cylinder, whose rims must be in the picture.
  const double radius = std::hypot(half[axes.First], half[axes.Second]);
  const double sine = towards[axes.Up];
  const double cosine = std::hypot(towards[axes.First], towards[axes.Second]);
  const double opening = FittedView::Filled *
    std::tan(0.5 * vtkMath::RadiansFromDegrees(renderer->GetActiveCamera()->GetViewAngle()));
  const double wide = opening * renderer->GetTiledAspectRatio();
  double distance = 0.0;
  for (int degrees = 0; degrees < 360; ++degrees)
  {
    const double angle = vtkMath::RadiansFromDegrees(static_cast<double>(degrees));
    for (const double height : { -half[axes.Up], half[axes.Up] })
    {
      const double near = radius * std::cos(angle) * cosine + height * sine;
      const double right = radius * std::sin(angle);
      const double above = height * cosine - radius * std::cos(angle) * sine;
      distance =
        std::max(distance, near + std::max(std::abs(right) / wide, std::abs(above) / opening));
    }
  }
  if (!(distance > 0.0)) // a point
  {
    return view;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    fitted.Position[axis] = fitted.FocalPoint[axis] + distance * towards[axis];
  }
  return fitted;
}

//------------------------------------------------------------------------------
std::vector<CameraPlace> MakeTurn(const CameraPlace& first, int frames, int up)
{
  const Axes axes(up);
  std::vector<CameraPlace> views;
  for (int frame = 0; frame < frames; ++frame)
  {
    // Exact at quarter turns.
    const int quarter = 4 * frame / frames;
    const double rest = 0.5 * vtkMath::Pi() * (4.0 * frame / frames - quarter);
    const double cosines[] = { std::cos(rest), -std::sin(rest), -std::cos(rest), std::sin(rest) };
    const double cosine = cosines[quarter];
    const double sine = cosines[(quarter + 3) % 4];
    const auto turn = [&](const std::array<double, 3>& v) {
      std::array<double, 3> turned = v;
      turned[axes.First] = cosine * v[axes.First] - sine * v[axes.Second];
      turned[axes.Second] = sine * v[axes.First] + cosine * v[axes.Second];
      return turned;
    };
    CameraPlace view = first;
    const std::array<double, 3> arm = turn(Minus(first.Position, first.FocalPoint));
    view.ViewUp = turn(first.ViewUp);
    for (std::size_t axis = 0; axis < 3 && frame > 0; ++axis)
    {
      view.Position[axis] = first.FocalPoint[axis] + arm[axis];
    }
    views.push_back(view);
  }
  return views;
}
}
