// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfParts.h"

#include <limits>

namespace relievo
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double HalfTurn = 3.14159265358979323846;

ModelLight ReadLight(const GltfValue& value, int node)
{
  ModelLight light;
  light.Node = node;
  light.Name = value.Get("name").GetText("");
  if (!value.Get("type").IsThere())
  {
    value.Get("type").FailExpecting("directional, point or spot");
  }
  light.Is =
    static_cast<ModelLight::Kind>(value.Get("type").GetWord({ "directional", "point", "spot" }));
  const std::vector<double> color = value.Get("color").GetNumbers({ 1., 1., 1. });
  light.Color = glm::dvec3(color[0], color[1], color[2]);
  light.Intensity = value.Get("intensity").GetNumber(1., 0., Infinity);
  light.Range = value.Get("range").GetNumber(0., 0., Infinity);
  const GltfValue spot = value.Get("spot");
  light.InnerCone = spot.Get("innerConeAngle").GetNumber(0., 0., HalfTurn / 2.);
  light.OuterCone = spot.Get("outerConeAngle").GetNumber(HalfTurn / 4., 0., HalfTurn / 2.);
  if (light.Is == ModelLight::Kind::Spot && light.InnerCone >= light.OuterCone)
  {
    spot.Fail("has an inner cone that is not within its outer cone");
  }
  return light;
}

ModelCamera ReadCamera(const GltfValue& value, int node)
{
  ModelCamera camera;
  camera.Node = node;
  camera.Name = value.Get("name").GetText("");
  camera.IsPerspective = value.Get("type").GetWord({ "perspective", "orthographic" }) == 0;
  const GltfValue kind = value.Get(camera.IsPerspective ? "perspective" : "orthographic");
  const GltfValue height = kind.Get(camera.IsPerspective ? "yfov" : "ymag");
  camera.Height = height.GetNumber(1., 0., camera.IsPerspective ? HalfTurn : Infinity);
  camera.Near = kind.Get("znear").GetNumber(0., 0., Infinity);
  camera.Far = kind.Get("zfar").GetNumber(0., 0., Infinity);
  return camera;
}
}

//------------------------------------------------------------------------------
void ReadGltfLightsAndCameras(GltfDocument& document, const GltfNodes& nodes, Model& model)
{
  const GltfValue lights = document.Get("extensions").Get("KHR_lights_punctual").Get("lights");
  const GltfValue cameras = document.Get("cameras");
  for (const int place : nodes.Shown)
  {
    const auto i = static_cast<std::size_t>(place);
    const GltfValue node = document.Get("nodes").At(i);
    const int light = node.Get("extensions")
                        .Get("KHR_lights_punctual")
                        .Get("light")
                        .GetIndex("lights", lights.GetSize());
    if (light >= 0)
    {
      model.Lights.push_back(ReadLight(lights.At(static_cast<std::size_t>(light)), nodes.Get(i)));
    }
    const int camera = node.Get("camera").GetIndex("cameras", cameras.GetSize());
    if (camera >= 0)
    {
      model.Cameras.push_back(
        ReadCamera(cameras.At(static_cast<std::size_t>(camera)), nodes.Get(i)));
    }
  }
}
}
