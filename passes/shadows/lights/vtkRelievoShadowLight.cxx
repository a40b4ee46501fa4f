// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowLight.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
const char* const AtEyeWords = "a light at the eye hides its own shadows";

// Whether the near plane cuts anything away: its shadow is visible although it is not.
bool IsCut(vtkRenderer* renderer, const glm::dvec3& eye, const glm::dvec3& gaze)
{
  const double nearest = renderer->GetActiveCamera()->GetClippingRange()[0];
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    const double* b = prop->GetVisibility() && prop->GetUseBounds() ? prop->GetBounds() : nullptr;
    if (b && vtkMath::AreBoundsInitialized(b))
    {
      const glm::dvec3 low(b[0], b[2], b[4]);
      const glm::dvec3 high(b[1], b[3], b[5]);
      const double middle = glm::dot(0.5 * (low + high) - eye, gaze);
      if (middle - glm::dot(0.5 * (high - low), glm::abs(gaze)) < nearest)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsAtEye(const vtkRelievoShadowLight& light, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 eye(0.0);
  glm::dvec3 gaze(0.0);
  camera->GetPosition(eye.x, eye.y, eye.z);
  camera->GetDirectionOfProjection(gaze.x, gaze.y, gaze.z);
  // Parallel rays along a parallel camera's view cast no visible shadow, except from casters in
  // front of the near plane; for a lamp this holds at the eye's position.
  const bool along = glm::length(light.Direction - gaze) < 1e-6;
  return light.Positional ? glm::length(light.Position - eye) <= 1e-6 * camera->GetDistance() &&
      !camera->GetParallelProjection()
                          : along && camera->GetParallelProjection() && !IsCut(renderer, eye, gaze);
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowLight> vtkRelievoShadowLight::Collect(vtkRenderer* renderer)
{
  std::vector<vtkRelievoShadowLight> lights;
  for (const vtkRelievoFrameLight& each : vtkRelievoFrameScene::FindLights(renderer))
  {
    vtkLight* source = each.Light;
    vtkRelievoShadowLight light;
    light.Light = source;
    light.Number = each.Number;
    light.ShaderIndex = each.ShaderIndex;
    light.Positional = source->GetPositional() != 0;
    light.ConeAngle = source->GetConeAngle();
    glm::dvec3 focus(0.0);
    source->GetTransformedPosition(light.Position.x, light.Position.y, light.Position.z);
    source->GetTransformedFocalPoint(focus.x, focus.y, focus.z);
    const double distance = glm::length(focus - light.Position);
    if (distance > 0.0 && std::isfinite(distance))
    {
      light.Direction = (focus - light.Position) / distance;
    }
    else if (!light.Positional || light.ConeAngle < 90.0)
    {
      light.NoShadow = "its position and focal point are the same: it has no direction";
      light.Broken = true;
    }
    if (light.ShaderIndex < 0)
    {
      light.NoShadow = "it is switched off";
      light.Broken = false;
    }
    else if (source->LightTypeIsHeadlight())
    {
      light.NoShadow = AtEyeWords;
      light.Broken = false;
    }
    else if (light.IsSpot() && light.ConeAngle <= 0.0)
    {
      light.NoShadow = "its cone angle is 0";
      light.Broken = true;
    }
    else if (light.NoShadow.empty() && IsAtEye(light, renderer))
    {
      light.AtEye = true;
      light.NoShadow = AtEyeWords;
    }
    lights.push_back(light);
  }
  return lights;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowLight::GetStrength() const
{
  return this->AtEye ? 0.0 : this->Light->GetShadowAttenuation();
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoShadowLight::AnySquareTo(const glm::dvec3& direction)
{
  constexpr double Rounding = 1e-6; // axes that differ by less are alike
  const glm::dvec3 size = glm::abs(direction);
  const double least = std::min({ size.x, size.y, size.z }) + Rounding;
  const glm::dvec3 axis = size.x <= least ? glm::dvec3(1, 0, 0)
    : size.y <= least                     ? glm::dvec3(0, 1, 0)
                                          : glm::dvec3(0, 0, 1);
  return glm::normalize(axis - direction * glm::dot(axis, direction));
}
