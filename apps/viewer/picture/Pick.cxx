// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pick.h"

#include "Picture.h"
#include "Probe.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <cmath>
#include <limits>

namespace viewer
{
namespace
{
constexpr double Outside = 1e6;     // limit in half pictures
constexpr double LeastDepth = 0.01; // in distances of the camera's focal point

std::array<double, 3> Between(
  const std::array<double, 3>& near, const std::array<double, 3>& far, double share)
{
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] = near[i] + share * (far[i] - near[i]);
  }
  return place;
}

std::array<double, 3> ToWorld(vtkRenderer* renderer, int x, int y, double depth)
{
  renderer->SetDisplayPoint(x + 0.5, y + 0.5, depth);
  renderer->DisplayToWorld();
  const double* point = renderer->GetWorldPoint();
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

// The intersection of the line through the pixel with the ground, which layers do not show.
std::optional<std::array<double, 3>> PickGround(const Picture& picture, int x, int y)
{
  const scene::StyledScene& scene = picture.GetScene();
  if (!scene.GetScene().Ground)
  {
    return std::nullopt;
  }
  const auto up = static_cast<std::size_t>(scene.GetOptions().UpAxis);
  const double height = scene.GetBounds()[2 * up];
  const std::array<double, 3> near = ToWorld(picture.GetRenderer(), x, y, 0.0);
  const std::array<double, 3> far = ToWorld(picture.GetRenderer(), x, y, 1.0);
  if (near[up] <= height || far[up] >= height) // the ground is visible only from above
  {
    return std::nullopt;
  }
  return Between(near, far, (near[up] - height) / (near[up] - far[up]));
}
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> Pick(const Picture& picture, Probe& probe, int x, int y)
{
  // The nearer of surface and volume; each depth comes before its position.
  std::optional<std::array<double, 3>> place;
  double nearest = std::numeric_limits<double>::infinity();
  double depth = nearest;
  for (const ProbeValue& value : probe.Read(picture.GetRenderer(), {}, x, y))
  {
    if (value.Layer == "depth" || value.Layer == "volume_depth")
    {
      depth = value.Values[0];
    }
    else if ((value.Layer == "position" || value.Layer == "volume_position") && depth < nearest)
    {
      nearest = depth;
      place = { value.Values[0], value.Values[1], value.Values[2] };
    }
  }
  if (place)
  {
    return place;
  }
  return picture.IsEmpty() ? std::nullopt : PickGround(picture, x, y);
}

//------------------------------------------------------------------------------
std::array<double, 2> Project(const Picture& picture, const std::array<double, 3>& place)
{
  vtkRenderer* renderer = picture.GetRenderer();
  const double from[] = { place[0], place[1], place[2], 1.0 };
  double to[4];
  renderer->GetActiveCamera()
    ->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)
    ->MultiplyPoint(from, to);
  if (to[3] > 0.0)
  {
    return { to[0] / to[3], to[1] / to[3] };
  }
  const double length = std::hypot(to[0], to[1]);
  return length > 0.0 ? std::array<double, 2>{ Outside * to[0] / length, Outside * to[1] / length }
                      : std::array<double, 2>{ 0.0, Outside };
}

//------------------------------------------------------------------------------
std::array<double, 3> MoveInView(
  const Picture& picture, const std::array<double, 3>& from, int x, int y)
{
  vtkCamera* camera = picture.GetRenderer()->GetActiveCamera();
  const double* at = camera->GetPosition();
  const double* along = camera->GetDirectionOfProjection();
  const std::array<double, 3> near = ToWorld(picture.GetRenderer(), x, y, 0.0);
  const std::array<double, 3> far = ToWorld(picture.GetRenderer(), x, y, 1.0);
  const auto depth = [&](const std::array<double, 3>& place) {
    return (place[0] - at[0]) * along[0] + (place[1] - at[1]) * along[1] +
      (place[2] - at[2]) * along[2];
  };
  const double wanted =
    depth(from) > LeastDepth * camera->GetDistance() ? depth(from) : camera->GetDistance();
  return Between(near, far, (wanted - depth(near)) / (depth(far) - depth(near)));
}
}
