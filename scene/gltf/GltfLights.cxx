// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfLights.h"

#include "GltfMaterials.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>

namespace scene
{
namespace
{
using Json = GltfBuffer::Json;

// A node whose -z points along a direction; `up` may be parallel to it.
GltfPlace Aim(const glm::dvec3& at, const glm::dvec3& along, glm::dvec3 up)
{
  const glm::dvec3 z = -glm::normalize(along);
  if (!(glm::length(glm::cross(up, z)) > 1e-6 * glm::length(up)))
  {
    up = std::abs(z.y) < 0.9 ? glm::dvec3(0., 1., 0.) : glm::dvec3(1., 0., 0.);
  }
  const glm::dvec3 x = glm::normalize(glm::cross(up, z));
  const glm::dvec3 y = glm::cross(z, x);
  return *GltfPlace::Find(
    glm::dmat4(glm::dvec4(x, 0.), glm::dvec4(y, 0.), glm::dvec4(z, 0.), glm::dvec4(at, 1.)));
}

double GetAttenuation(vtkLight* light, double distance)
{
  const double* factors = light->GetAttenuationValues();
  const double below = factors[0] + distance * (factors[1] + distance * factors[2]);
  return below > 0. ? 1. / below : 1.;
}
}

//------------------------------------------------------------------------------
std::vector<std::size_t> AddLights(GltfBuffer& buffer, vtkRenderer* renderer,
  const glm::dvec3& center, bool isPBR, std::set<std::string>& notes)
{
  static const char* const extension = "KHR_lights_punctual";
  std::vector<std::size_t> nodes;
  Json lights = Json::array();
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  while (vtkLight* light = all->GetNextLight(it))
  {
    if (!light->GetSwitch() || !(light->GetIntensity() > 0.))
    {
      continue;
    }
    glm::dvec3 at;
    glm::dvec3 to;
    light->GetTransformedPosition(&at.x);
    light->GetTransformedFocalPoint(&to.x);
    const bool isSpot = light->GetPositional() && light->GetConeAngle() < 90.;
    glm::dvec3 along = to - at;
    if (!(glm::length(along) > 0.) && light->GetPositional() && !isSpot)
    {
      along = glm::dvec3(0., 0., -1.); // a point light has no direction
    }
    if (!(glm::length(along) > 0.) || !std::isfinite(glm::length(at) + glm::length(along)) ||
      (isSpot && !(light->GetConeAngle() > 0.)))
    {
      notes.insert("a light without a direction or a cone is left out");
      continue;
    }
    const double* color = light->GetDiffuseColor();
    Json linear = Json::array();
    for (int i = 0; i < 3; ++i)
    {
      linear.push_back(ToLinear(color[i], isPBR));
    }
    double intensity = light->GetIntensity() * (isPBR ? 1. : vtkMath::Pi());
    Json written = { { "color", linear } };
    if (light->GetPositional())
    {
      const double distance = std::max(glm::length(center - at), 1e-30);
      const double* factors = light->GetAttenuationValues();
      if (factors[0] != 0. || factors[1] != 0.)
      {
        notes.insert("lights fall off with the square of the distance, as glTF has them");
      }
      intensity *= GetAttenuation(light, distance) * distance * distance;
      written["type"] = isSpot ? "spot" : "point";
      if (isSpot)
      {
        const double outer = vtkMath::RadiansFromDegrees(light->GetConeAngle());
        constexpr double sharp = 0.999; // glTF's inner cone is inside the outer cone
        written["spot"] = { { "innerConeAngle", light->GetExponent() > 0. ? 0. : sharp * outer },
          { "outerConeAngle", outer } };
      }
    }
    else
    {
      written["type"] = "directional";
    }
    written["intensity"] = intensity;
    Json node = Aim(at, along, glm::dvec3(0., 1., 0.)).GetNode("");
    node["extensions"][extension] = { { "light", lights.size() } };
    lights.push_back(std::move(written));
    nodes.push_back(buffer.Append("nodes", std::move(node)));
  }
  if (!lights.empty())
  {
    buffer.Use(extension);
    buffer.Document["extensions"][extension] = { { "lights", lights } };
  }
  return nodes;
}

//------------------------------------------------------------------------------
GltfPlace GetCameraPlace(vtkRenderer* renderer)
{
  glm::dvec3 at;
  glm::dvec3 along;
  glm::dvec3 up;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(&at.x);
  camera->GetDirectionOfProjection(&along.x);
  camera->GetViewUp(&up.x);
  return Aim(at, along, up);
}

//------------------------------------------------------------------------------
std::size_t AddCamera(GltfBuffer& buffer, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect = std::max(renderer->GetTiledAspectRatio(), 1e-6);
  const double* range = camera->GetClippingRange();
  const double near = std::max(range[0], 0.);
  const double far = std::max(range[1], near + std::max(1e-6, 1e-6 * near));
  Json written;
  if (camera->GetParallelProjection())
  {
    const double half = camera->GetParallelScale();
    written = { { "type", "orthographic" },
      { "orthographic",
        { { "xmag", half * aspect }, { "ymag", half }, { "znear", near }, { "zfar", far } } } };
  }
  else
  {
    double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
    angle =
      camera->GetUseHorizontalViewAngle() ? 2. * std::atan(std::tan(angle / 2.) / aspect) : angle;
    written = { { "type", "perspective" },
      { "perspective",
        { { "aspectRatio", aspect }, { "yfov", angle }, { "znear", std::max(near, 1e-6 * far) },
          { "zfar", far } } } };
  }
  Json node = GetCameraPlace(renderer).GetNode("camera");
  node["camera"] = buffer.Append("cameras", std::move(written));
  return buffer.Append("nodes", std::move(node));
}
}
