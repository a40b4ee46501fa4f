// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pick.h"

#include "Picture.h"
#include "Probe.h"

#include "vtkRenderer.h"

namespace viewer
{
namespace
{
std::array<double, 3> ToWorld(vtkRenderer* renderer, int x, int y, double depth)
{
  renderer->SetDisplayPoint(x + 0.5, y + 0.5, depth);
  renderer->DisplayToWorld();
  const double* point = renderer->GetWorldPoint();
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

// Where the line through the pixel meets the ground, which layers do not have.
std::optional<std::array<double, 3>> PickGround(const Picture& picture, int x, int y)
{
  const scene::DressedScene& scene = picture.GetScene();
  if (!scene.GetBare().Get().Ground)
  {
    return std::nullopt;
  }
  const auto up = static_cast<std::size_t>(scene.GetOptions().UpAxis);
  const double height = scene.GetBounds()[2 * up];
  const std::array<double, 3> near = ToWorld(picture.GetRenderer(), x, y, 0.0);
  const std::array<double, 3> far = ToWorld(picture.GetRenderer(), x, y, 1.0);
  if (near[up] <= height || far[up] >= height) // it is seen from above
  {
    return std::nullopt;
  }
  const double share = (near[up] - height) / (near[up] - far[up]);
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] = near[i] + share * (far[i] - near[i]);
  }
  return place;
}
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> Pick(const Picture& picture, Probe& probe, int x, int y)
{
  for (const ProbeValue& value : probe.Read(picture.GetRenderer(), {}, x, y))
  {
    if (value.Layer == "position" && !value.IsBackground)
    {
      return std::array<double, 3>{ value.Values[0], value.Values[1], value.Values[2] };
    }
  }
  return picture.IsEmpty() ? std::nullopt : PickGround(picture, x, y);
}
}
