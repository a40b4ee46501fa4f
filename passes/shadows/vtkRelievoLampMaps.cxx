// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampMaps.h"

#include "vtkRelievoFrameContext.h"
#include "vtkRelievoShadowMapUniforms.h"
#include "vtkShaderProgram.h"

#include <sstream>

//------------------------------------------------------------------------------
std::string vtkRelievoLampMaps::Draw(
  vtkRelievoFrameContext& context, int size, int radius, double strength)
{
  this->DrawCalls = 0;
  this->Strengths.clear();
  this->Work.View = context.View;
  this->Work.SteadyView = context.SteadyView;
  std::vector<vtkRelievoShadowLight> lights;
  for (const vtkRelievoCastingLamp& lamp : context.CastingLamps)
  {
    vtkRelievoShadowLight light;
    light.Number = static_cast<int>(lights.size());
    light.Positional = true;
    light.Position = lamp.Position;
    light.Reach = lamp.Radius;
    lights.push_back(light);
    this->Strengths.push_back(strength * lamp.Strength);
  }
  const std::string fault =
    this->Schedule.Fit(this->Work, lights, this->Method, size, radius, context.Renderer);
  if (fault.empty())
  {
    this->DrawCalls = this->Schedule.Draw(this->Work, context.Renderer);
    this->Work.Maps.Bind(true);
  }
  return fault;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampMaps::GetReport() const
{
  const auto lamps = this->Strengths.size();
  const int maps = this->Work.Cache.GetNumberOfMaps();
  std::ostringstream out;
  out << lamps << (lamps == 1 ? " lamp casts, " : " lamps cast, ") << maps
      << (maps == 1 ? " map of " : " maps of ") << this->Work.Maps.GetSize() << " x "
      << this->Work.Maps.GetSize() << " texels, " << this->Work.MapsDrawn << " drawn anew"
      << this->Schedule.Exchange.GetReport();
  return out.str();
}

//------------------------------------------------------------------------------
void vtkRelievoLampMaps::Release(vtkWindow* window)
{
  this->Work.Maps.Release(window);
  this->Work.Cache.Clear();
  this->Work.MapsDrawn = 0;
  this->Strengths.clear();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampMaps::GetDefines() const
{
  return this->Work.Radius > 1 ? "#define RELIEVO_LAMP_SHADOWS\n#define RELIEVO_SHADOW_WIDE\n"
                               : "#define RELIEVO_LAMP_SHADOWS\n";
}

//------------------------------------------------------------------------------
void vtkRelievoLampMaps::Activate(vtkShaderProgram* program)
{
  program->SetUniformf("relievoShadowInner", this->Work.GetInner());
}

//------------------------------------------------------------------------------
void vtkRelievoLampMaps::SetLamp(vtkShaderProgram* program, int lamp)
{
  constexpr int Sides = 6; // of a cube, as in shaders/shadow/lamp.glsl
  const auto& entries = this->Work.Cache.GetEntries();
  const auto place = static_cast<std::size_t>(lamp);
  glm::vec3 center(0.f);
  if (place < entries.size())
  {
    // The lamp's place in eye space in float, like the shader's.
    center =
      glm::vec3(this->Work.View.WorldToView * glm::dvec4(entries[place].Light.Position, 1.0));
  }
  vtkRelievoShadowMapUniforms faces(this->Work, Sides, center);
  for (int face = 0; place < entries.size() && face < static_cast<int>(entries[place].Maps.size());
       ++face)
  {
    const vtkRelievoShadowCache::Map& map = entries[place].Maps[face];
    faces.Set(face, map, this->Method.GetBias(map.View, this->Work.Bias));
  }
  faces.Tell(program);
  program->SetUniformf("relievoShadowStrength",
    place < this->Strengths.size() ? static_cast<float>(this->Strengths[place]) : 0.f);
}
