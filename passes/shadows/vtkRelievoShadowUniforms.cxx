// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowUniforms.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowWork.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <vector>

//------------------------------------------------------------------------------
void vtkRelievoShadowUniforms::SetFrame(vtkShaderProgram* program, const vtkRelievoShadowWork& work,
  const vtkRelievoShadowMethod& method, double strength)
{
  const glm::dmat4 viewToWorld = glm::inverse(work.View.WorldToView);
  const glm::dmat4 ndcToMap = vtkRelievoShadowMaps::GetNDCToMap(work.Maps.GetSize());
  // As the shader has it, in float.
  const glm::vec3 center(work.View.WorldToView * glm::dvec4(work.Cache.GetCenter(), 1.0));
  glm::dmat4 fromCenter(1.0);
  fromCenter[3] = glm::dvec4(glm::dvec3(center), 1.0);
  const int faces = work.Structure.GetFaces();
  // Where there is no map, every point is outside of it.
  glm::mat4 nowhere(0.f);
  nowhere[3] = glm::vec4(-1e9f, -1e9f, 0.f, 1.f);
  std::vector<glm::mat4> matrices(faces, nowhere);
  std::vector<glm::vec4> eyes(faces, glm::vec4(0.f));
  std::vector<float> texels(faces, 0.f);
  std::vector<float> layers(faces, 0.f);
  std::vector<float> lowest(faces, -1.f);
  std::vector<float> strengths;
  std::vector<int> slots(work.Structure.Numbers, -1);
  int first = 0;
  for (const auto& entry : work.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    int face = first;
    for (const auto& map : entry.Maps)
    {
      const glm::dmat4 viewToMap =
        ndcToMap * map.View.ViewToNDC * (map.View.WorldToView * viewToWorld);
      glm::dmat4 biased = viewToMap;
      biased[3].z -= method.GetBias(map.View, work.Bias);
      matrices[face] = glm::mat4(biased * fromCenter);
      eyes[face] = glm::vec4(
        viewToMap * (work.View.Parallel ? glm::dvec4(0, 0, 1, 0) : glm::dvec4(0, 0, 0, 1)));
      texels[face] = static_cast<float>(map.View.Texel);
      lowest[face] = map.View.NearCut ? 1e-7f : -1e9f;
      layers[face++] = static_cast<float>(map.Layer);
    }
    first += work.Structure.Lights[strengths.size()].GetRoom();
    slots[light.Number] = static_cast<int>(strengths.size());
    strengths.push_back(static_cast<float>(strength * light.Light->GetShadowAttenuation()));
  }
  const int lights = static_cast<int>(strengths.size());
  program->SetUniformi("relievoShadowMaps", work.Maps.GetTextureUnit());
  program->SetUniform3f("relievoShadowCenter", &center.x);
  program->SetUniformMatrix4x4v("relievoShadowMatrix", faces, &matrices[0][0][0]);
  program->SetUniform4fv(
    "relievoShadowEye", faces, reinterpret_cast<const float(*)[4]>(&eyes[0][0]));
  program->SetUniform1fv("relievoShadowTexel", faces, texels.data());
  program->SetUniform1fv("relievoShadowLayer", faces, layers.data());
  program->SetUniform1fv("relievoShadowLowest", faces, lowest.data());
  program->SetUniform1fv("relievoShadowStrength", lights, strengths.data());
  program->SetUniform1iv("relievoShadowSlot", work.Structure.Numbers, slots.data());
  const bool mirrored = work.View.GetWinding() < 0.0;
  program->SetUniformf("relievoShadowHand", mirrored ? 1.f : -1.f);
  program->SetUniformf("relievoShadowSize", static_cast<float>(work.Maps.GetSize()));
  program->SetUniformi("relievoShadowRadius", work.Radius);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowUniforms::SetActor(
  vtkShaderProgram* program, const vtkRelievoShadowWork& work, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  program->SetUniformi("relievoShadowFaces", property->GetRepresentation() == VTK_SURFACE ? 1 : 0);
  program->SetUniformf("relievoShadowInner",
    work.Props.Receives(actor) ? 0.5f * (work.Maps.GetSize() - 1) - work.Radius : -1.f);
  program->SetUniformf(
    "relievoShadowLift", std::max(property->GetPointSize(), property->GetLineWidth()));
}
