// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FittedView.h"

#include "Triples.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace look
{
namespace
{
bool IsFlatAlong(const double bounds[6], int axis)
{
  const double largest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  return bounds[2 * axis + 1] - bounds[2 * axis] <= 1e-6 * largest;
}
}

//------------------------------------------------------------------------------
// An environment's z axis: with z up, the view of a world with y up is turned about x.
FittedView::FittedView(int up)
  : Up(up)
  , Towards(
      up == 2 ? std::array<double, 3>{ 0.0, -1.0, 0.0 } : std::array<double, 3>{ 0.0, 0.0, 1.0 })
{
  this->ViewUp[static_cast<std::size_t>(up)] = 1.0;
}

//------------------------------------------------------------------------------
std::array<double, 3> FittedView::ToWorld(const std::array<double, 3>& right_up_near) const
{
  auto [right, up, near] = right_up_near;
  const double length = Length(right_up_near);
  right /= length;
  up /= length;
  near /= length;
  return this->Up == 0 ? std::array<double, 3>{ up, -right, near }
    : this->Up == 2    ? std::array<double, 3>{ right, -near, up }
                       : std::array<double, 3>{ right, up, near };
}

//------------------------------------------------------------------------------
bool FittedView::IsFlat(const double bounds[6])
{
  return vtkMath::AreBoundsInitialized(bounds) &&
    (IsFlatAlong(bounds, 0) || IsFlatAlong(bounds, 1) || IsFlatAlong(bounds, 2));
}

//------------------------------------------------------------------------------
void FittedView::TurnToFlatSide(const double bounds[6])
{
  const int depth = this->Up == 2 ? 1 : 2; // axis along the view
  const int side = 3 - this->Up - depth;
  const int axis = IsFlatAlong(bounds, side) ? side : this->Up;
  if (IsFlatAlong(bounds, depth) || !IsFlatAlong(bounds, axis))
  {
    return;
  }
  if (axis == this->Up)
  {
    this->ViewUp = { -this->Towards[0], -this->Towards[1], -this->Towards[2] };
  }
  this->Towards = {};
  this->Towards[static_cast<std::size_t>(axis)] = 1.0;
}

//------------------------------------------------------------------------------
void FittedView::TurnTo(const std::array<double, 3>& right_up_near)
{
  this->Towards = this->ToWorld(right_up_near);
}

//------------------------------------------------------------------------------
void FittedView::Turn(vtkRenderer* renderer) const
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(this->Towards.data());
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(this->ViewUp.data());
}

//------------------------------------------------------------------------------
void FittedView::Fit(vtkRenderer* renderer, const double bounds[6]) const
{
  this->Turn(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double angle = camera->GetViewAngle();
  renderer->ResetCamera(bounds); // sets VTK's view angle and the distance for it
  if (angle == camera->GetViewAngle())
  {
    return;
  }
  const double aspect = std::min(1.0, renderer->GetTiledAspectRatio());
  const auto sine = [aspect](double degrees) {
    return std::sin(std::atan(aspect * std::tan(0.5 * vtkMath::RadiansFromDegrees(degrees))));
  };
  const double distance = camera->GetDistance() * sine(camera->GetViewAngle()) / sine(angle);
  camera->SetViewAngle(angle);
  std::array<double, 3> place{};
  for (int i = 0; i < 3; ++i)
  {
    place[static_cast<std::size_t>(i)] =
      camera->GetFocalPoint()[i] + distance * this->Towards[static_cast<std::size_t>(i)];
  }
  camera->SetPosition(place.data());
}

//------------------------------------------------------------------------------
void FittedView::FitTightly(vtkRenderer* renderer, const double bounds[6]) const
{
  this->Fit(renderer, bounds);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double size =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (!vtkMath::AreBoundsInitialized(bounds) || size == 0.0)
  {
    return;
  }
  // The picture's axes, and the view's slopes along two of them.
  std::array<double, 3> up{};
  std::array<double, 3> right{};
  const std::array<double, 3>& towards = this->Towards;
  vtkMath::Cross(this->ViewUp.data(), towards.data(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(towards.data(), right.data(), up.data());
  const double opening =
    Filled * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const std::array<double, 2> slopes = { opening * renderer->GetTiledAspectRatio(), opening };

  // For a camera at (x, y) and at the distance d along `towards`, a corner (cx, cy, cz) is in the
  // picture if x + slope d >= cx + slope cz and slope d - x >= slope cz - cx; y behaves alike.
  std::array<double, 2> ahead = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  std::array<double, 2> behind = ahead;
  std::array<double, 2> highest = ahead;
  std::array<double, 2> lowest = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double nearest = -VTK_DOUBLE_MAX;
  std::array<double, 3> middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<double, 3> place{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto i = static_cast<std::size_t>(axis);
      place[i] = bounds[2 * axis + ((corner >> axis) & 1)] - middle[i];
    }
    const double across[2] = { vtkMath::Dot(place.data(), right.data()),
      vtkMath::Dot(place.data(), up.data()) };
    const double near = vtkMath::Dot(place.data(), towards.data());
    nearest = std::max(nearest, near);
    for (std::size_t i = 0; i < 2; ++i)
    {
      ahead[i] = std::max(ahead[i], slopes[i] * near + across[i]);
      behind[i] = std::max(behind[i], slopes[i] * near - across[i]);
      highest[i] = std::max(highest[i], across[i]);
      lowest[i] = std::min(lowest[i], across[i]);
    }
  }
  double distance = nearest + 0.1 * size; // keeps the camera outside the bounds
  std::array<double, 2> at{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    at[i] = camera->GetParallelProjection() ? 0.5 * (highest[i] + lowest[i])
                                            : 0.5 * (ahead[i] - behind[i]);
    distance = std::max(distance, 0.5 * (ahead[i] + behind[i]) / slopes[i]);
  }
  std::array<double, 3> focus{};
  std::array<double, 3> position{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    focus[axis] = middle[axis] + at[0] * right[axis] + at[1] * up[axis];
    position[axis] = focus[axis] + distance * towards[axis];
  }
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetParallelScale(0.5 / Filled *
    std::max((highest[0] - lowest[0]) / renderer->GetTiledAspectRatio(), highest[1] - lowest[1]));
}
}
