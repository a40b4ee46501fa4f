// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodWarped.h"

#include "vtkMath.h"
#include "vtkRelievoLightSpace.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowLight.h"
#include "vtkRelievoShadowSnapping.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
using Frame = vtkRelievoLightSpace;
using vtkRelievoShadowFit::Request;
using vtkRelievoShadowSnapping::Rounding;

// Possible angles of a map, in half a turn.
constexpr double GazeTurns = 16.0;
// Possible places along a map for its finest texels.
constexpr double FocusPlaces = 8.0;
// Component of a gaze along the map below which the camera sees all of the map equally well.
constexpr double LeastAlong = 0.2;
// Ratio of the farthest to the nearest visible depth from which an uneven map errs less than an
// even one: by docs/charts/shadows/shadows.csv, not on a table, with a ratio below 3, but for rows
// to the horizon.
constexpr double LeastDeep = 4.0;
// Bound of the ratio of the widest texel to an even map's, for the range of the bias.
constexpr double WidestTexel = 8.0;

// The frame whose depth is the height over the ground, the plane perpendicular to the axis nearest
// to the view-up: rays are sheared upright, and the map lies in the ground. Rays stay unsheared if
// the sun is too low.
Frame GetFrameOfGround(
  const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& viewUp)
{
  constexpr double Lowest = 0.03;
  auto nearestAxis = [](const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    const double most = std::max({ size.x, size.y, size.z }) - Rounding;
    return size.x >= most ? 0 : size.y >= most ? 1 : 2;
  };
  int axis = nearestAxis(viewUp);
  if (std::abs(direction[axis]) < Lowest)
  {
    axis = nearestAxis(direction);
  }
  glm::dvec3 forward(0.0);
  forward[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
  Frame frame(origin, forward);
  const double depth = glm::dot(direction, forward);
  frame.Shear =
    glm::dvec2(glm::dot(direction, frame.Right) / depth, glm::dot(direction, frame.Up) / depth);
  return frame;
}

// Whether the ratio of the largest to the smallest depth justifies an uneven map; otherwise an even
// map may have the orientation with the fewest texels.
bool IsDeep(const std::vector<glm::dvec3>& visible, const Request& request)
{
  double nearest = 1e300;
  double farthest = 0.0;
  for (const glm::dvec3& point : visible)
  {
    const double depth = glm::dot(point - request.Eye, request.Gaze);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  return !request.ParallelEye && farthest > LeastDeep * nearest;
}

// The camera's demand along the u axis, which runs along its gaze: the place with the highest
// density, and the ratio to that at the farther end. Pixels on a surface grow with their distance
// from the eye; across the gaze, distance changes little.
void Warp(
  vtkRelievoShadowView& view, const std::vector<glm::dvec3>& visible, const Request& request)
{
  const glm::dmat4 worldToNDC = view.ViewToNDC * view.WorldToView;
  double nearest = 1e300;
  double farthest = 0.0;
  double focus = 0.5;
  for (const glm::dvec3& point : visible)
  {
    const double depth = glm::dot(point - request.Eye, request.Gaze);
    farthest = std::max(farthest, depth);
    if (depth < nearest)
    {
      nearest = depth;
      focus = 0.5 + 0.5 * (worldToNDC * glm::dvec4(point, 1.0)).x;
    }
  }
  if (nearest > 0.0)
  {
    view.U.Warp(std::round(FocusPlaces * focus) / FocusPlaces,
      vtkRelievoShadowSnapping::Up(farthest / nearest, 36.0, 2), request.Size);
  }
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowView> vtkRelievoShadowMethodWarped::Fit(
  const vtkRelievoShadowLight& light, const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
  const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
  const std::vector<vtkRelievoBox>& casters, const Request& request) const
{
  const std::vector<glm::dvec3> points = vtkRelievoShadowRegion::GetPoints(visible);
  if (light.Positional || !IsDeep(points, request))
  {
    return vtkRelievoShadowFit::Fit(light, visible, scene, casters, request);
  }
  const Frame frame =
    GetFrameOfGround(vtkRelievoShadowRegion::GetMiddle(scene), light.Direction, request.ViewUp);
  const glm::dvec2 along(glm::dot(request.Gaze, frame.Right), glm::dot(request.Gaze, frame.Up));
  vtkRelievoMapPlacement placement;
  placement.Turned = glm::length(along) > LeastAlong;
  if (placement.Turned)
  {
    const double turn = vtkMath::Pi() / GazeTurns;
    placement.Angle = turn * std::round(std::atan2(along.y, along.x) / turn);
    placement.Widest = WidestTexel;
  }
  vtkRelievoShadowView view;
  if (!frame.Fit(
        true, points, vtkRelievoShadowRegion::GetPoints(scene), casters, request, view, placement))
  {
    return {};
  }
  if (placement.Turned)
  {
    Warp(view, points, request);
  }
  return { view };
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodWarped::SetFrameUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowContext& work) const
{
  const int faces = work.Structure.GetFaces();
  std::vector<glm::vec4> breaks(faces, glm::vec4(1e30f));
  std::vector<glm::vec4> scales(faces, glm::vec4(1.f, 0.f, 0.f, 0.f));
  std::vector<glm::vec4> offsets(faces, glm::vec4(0.f));
  std::vector<float> across(faces, 1.f);
  const double size = work.Maps.GetSize();
  int first = 0;
  int slot = 0;
  for (const auto& entry : work.Cache.GetEntries())
  {
    int face = first;
    for (const auto& map : entry.Maps)
    {
      // A texel's place x maps to scale * x + offset; each piece adds to the previous ones.
      const vtkRelievoMapAxis& axis = map.View.U;
      double scale = 0.0;
      double offset = 0.0;
      for (int i = 0; i < axis.Pieces; ++i)
      {
        const double s = (axis.To[i + 1] - axis.To[i]) / (axis.From[i + 1] - axis.From[i]);
        const double o = (axis.To[i] - s * axis.From[i]) * size + 0.5 * s - 0.5;
        scales[face][i] = static_cast<float>(s - scale);
        offsets[face][i] = static_cast<float>(o - offset);
        if (i > 0)
        {
          breaks[face][i - 1] = static_cast<float>(axis.From[i] * size - 0.5);
        }
        scale = s;
        offset = o;
      }
      across[face++] = static_cast<float>(map.View.Height / map.View.Width);
    }
    first += work.Structure.Lights[slot++].GetRoom();
  }
  auto floats = [](std::vector<glm::vec4>& v) {
    return reinterpret_cast<const float(*)[4]>(&v[0][0]);
  };
  program->SetUniform4fv("relievoShadowBreaks", faces, floats(breaks));
  program->SetUniform4fv("relievoShadowScales", faces, floats(scales));
  program->SetUniform4fv("relievoShadowOffsets", faces, floats(offsets));
  program->SetUniform1fv("relievoShadowAcross", faces, across.data());
  program->SetUniformf("relievoShadowBias", static_cast<float>(work.Bias));
}

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodWarped::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  estimate.Bytes = vtkRelievoShadowMaps::GetBytes(demand.MapSize, demand.Maps);
  estimate.DrawCalls = demand.Maps * demand.Props * vtkRelievoMapAxis::MostPieces;
  // On the meshes of its law it equals map; for scenes to the horizon it has 36 to 55 % of that.
  estimate.WrongShare = vtkRelievoShadowMapLaw.GetShare(demand.MapSize);
  return estimate;
}
