// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowUniforms.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMapUniforms.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <vector>

namespace
{
// Steps of a part's ray through a map.
constexpr float MostSteps = 12.f;

// Sets the uniforms that are constant for a program in a frame.
void SetFrame(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
  const vtkRelievoShadowMethod& method, double strength)
{
  // The centre of the visible receivers in eye space in float, like the shader's.
  const glm::vec3 center(work.View.WorldToView * glm::dvec4(work.Cache.GetCenter(), 1.0));
  vtkRelievoShadowMapUniforms faces(work, work.Structure.GetFaces(), center);
  std::vector<float> strengths;
  std::vector<int> slots(work.Structure.Numbers, -1);
  std::vector<glm::vec3> rays;
  const auto parts = static_cast<std::ptrdiff_t>(work.Structure.Parts);
  int first = 0;
  for (const auto& entry : work.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    int face = first;
    for (const auto& map : entry.Maps)
    {
      faces.Set(face++, map, method.GetBias(map.View, work.Bias));
    }
    rays.resize(rays.size() + work.Structure.Parts, glm::vec3(0.f));
    if (parts > 0 && light.Parts.size() == static_cast<std::size_t>(parts) &&
      entry.Maps.size() == light.Centers.size())
    {
      std::transform(light.Parts.begin(), light.Parts.end(), rays.end() - parts,
        [&](const vtkRelievoShadowLight::Part& part) {
          const vtkRelievoShadowView& view = entry.Maps[static_cast<std::size_t>(part.Map)].View;
          return glm::vec3(work.Maps.GetRay(view, part.Direction), part.Map);
        });
    }
    first += work.Structure.Lights[strengths.size()].GetRoom();
    slots[light.Number] = static_cast<int>(strengths.size());
    strengths.push_back(static_cast<float>(strength * light.GetStrength()));
  }
  const int lights = static_cast<int>(strengths.size());
  faces.Tell(program);
  if (work.Shade.IsMade())
  {
    glm::dmat4 fromCenter(1.0);
    fromCenter[3] = glm::dvec4(glm::dvec3(center), 1.0);
    work.Shade.SetUniforms(program, glm::inverse(work.View.WorldToView) * fromCenter);
  }
  program->SetUniform3f("relievoShadowCenter", &center.x);
  program->SetUniform1fv("relievoShadowStrength", lights, strengths.data());
  program->SetUniform1iv("relievoShadowSlot", work.Structure.Numbers, slots.data());
  const glm::mat4 rows(glm::transpose(work.TileToPicture * work.View.ViewToNDC));
  const glm::vec4 heights[] = { rows[1], rows[3] };
  program->SetUniform4fv("relievoCatcherHeight", 2, reinterpret_cast<const float(*)[4]>(heights));
  program->SetUniform3f("relievoCatcherRise", &work.BackgroundRise.x);
  const bool mirrored = work.View.GetWinding() < 0.0;
  program->SetUniformf("relievoShadowHand", mirrored ? 1.f : -1.f);
  if (parts > 0)
  {
    program->SetUniform3fv("relievoShadowRays", static_cast<int>(rays.size()),
      reinterpret_cast<const float(*)[3]>(rays.data()));
    program->SetUniform2f("relievoShadowPartStep", &work.PartStep.x);
    program->SetUniformf("relievoShadowSteps", MostSteps);
    if (work.Structure.Nearest)
    {
      work.Maps.GetNearest().Tell(program);
    }
  }
}

void SetActor(vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  program->SetUniformi("relievoShadowFaces", property->GetRepresentation() == VTK_SURFACE ? 1 : 0);
  program->SetUniformf("relievoShadowInner", work.Props.Receives(actor) ? work.GetInner() : -1.f);
  program->SetUniformf(
    "relievoShadowLift", std::max(property->GetPointSize(), property->GetLineWidth()));
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowUniforms::Set(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
  const vtkRelievoShadowMethod& method, double strength, vtkActor* actor)
{
  if (this->Programs.insert(program).second)
  {
    // Another renderer's lights may be newer, and both may share a program in VTK's shader cache.
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    SetFrame(program, work, method, strength);
    method.SetFrameUniforms(program, work);
  }
  SetActor(program, work, actor);
  method.SetActorUniforms(program, work, actor);
}
