// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowPass.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoShadowSplice.h"
#include "vtkRelievoView.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>
#include <sstream>

vtkStandardNewMacro(vtkRelievoShadowPass);

namespace
{
// Room for uniforms: two matrices each.
constexpr int MostFaces = 48;
}

class vtkRelievoShadowPass::Internals
{
public:
  std::vector<vtkRelievoShadowLight> Lights;  // all of the renderer, in this frame
  std::vector<vtkRelievoShadowLight> Casting; // those with a place in the shaders
  std::vector<vtkWeakPointer<vtkLight>> NotCasting; // chosen so
  vtkRelievoShadowProps Props;
  vtkRelievoShadowCache Cache;
  vtkRelievoShadowMaps Maps;
  vtkRelievoCasterDraw PlainDraw;
  vtkRelievoShadowSplice::Structure Structure;
  vtkTimeStamp StructureTime;
  vtkRelievoView View;
  bool DrawingMaps = false;
  std::set<vtkShaderProgram*> Told;   // programs that have this frame's parameters
  std::set<vtkShaderProgram*> Lightly; // programs that VTK gave its lights in a light's eye space
  std::set<std::string> Said;
  bool Spliced = false;

  bool IsChosen(vtkLight* light) const
  {
    return std::find(this->NotCasting.begin(), this->NotCasting.end(), light) ==
      this->NotCasting.end();
  }
};

//------------------------------------------------------------------------------
vtkRelievoShadowPass::vtkRelievoShadowPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoShadowPass::~vtkRelievoShadowPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightCasts(vtkLight* light, bool casts)
{
  auto& list = this->Internal->NotCasting;
  list.erase(std::remove_if(list.begin(), list.end(),
               [light](const vtkWeakPointer<vtkLight>& known) {
                 return !known || known.GetPointer() == light;
               }),
    list.end());
  if (!casts && light)
  {
    list.emplace_back(light);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetLightCasts(vtkLight* light)
{
  return this->Internal->IsChosen(light);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropCasts(vtkProp* prop, int casts)
{
  if (!prop || casts < CASTS_IF_OPAQUE || casts > CASTS_ALWAYS)
  {
    vtkErrorMacro("SetPropCasts was given " << (prop ? "casting " : "no prop and casting ")
                                            << casts << "; give it a vtkProp of the renderer, and "
                                            << "-1 (if opaque), 0 (never) or 1 (always).");
    return;
  }
  this->Internal->Props.GetChoice(prop).Casts = casts;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetPropCasts(vtkProp* prop)
{
  return this->Internal->Props.GetChoice(prop).Casts;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropReceives(vtkProp* prop, bool receives)
{
  if (!prop)
  {
    vtkErrorMacro("SetPropReceives was given no prop; give it a vtkProp of the renderer.");
    return;
  }
  this->Internal->Props.GetChoice(prop).Receives = receives;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetPropReceives(vtkProp* prop)
{
  return this->Internal->Props.GetChoice(prop).Receives;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfCastingLights()
{
  return static_cast<int>(this->Internal->Casting.size());
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfMaps()
{
  return this->Internal->Cache.GetNumberOfMaps();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::IsNeeded(const vtkRenderState* s, std::string& reason)
{
  Internals& in = *this->Internal;
  if (!this->Visible && !this->LayersAsked)
  {
    in.Casting.clear();
    reason = "shadows are off";
    return false;
  }
  vtkRenderer* renderer = s->GetRenderer();
  vtkRelievoAccess::Renderer::FollowCamera(renderer);
  in.Lights = vtkRelievoShadowLight::Collect(renderer);
  in.Casting.clear();
  std::ostringstream without;
  int faces = 0;
  for (vtkRelievoShadowLight& light : in.Lights)
  {
    if (light.NoShadow.empty() && !in.IsChosen(light.Light))
    {
      light.NoShadow = "it is chosen to cast none (SetLightCasts)";
    }
    if (light.NoShadow.empty() && faces + (light.Positional ? 6 : 1) > MostFaces)
    {
      light.NoShadow = "the lights before it take all maps that a shader has room for";
      light.Broken = true;
    }
    if (light.NoShadow.empty())
    {
      faces += light.Positional ? 6 : 1;
      in.Casting.push_back(light);
      continue;
    }
    without << "; light " << light.Number << " casts none: " << light.NoShadow;
    if (light.Broken && in.Said.insert(std::to_string(light.Number) + light.NoShadow).second)
    {
      vtkWarningMacro("Light " << light.Number << " casts no shadow: " << light.NoShadow << ".");
    }
  }
  std::ostringstream out;
  if (in.Casting.empty())
  {
    out << "no light casts" << without.str();
    reason = out.str();
    return false;
  }
  out << in.Casting.size() << (in.Casting.size() == 1 ? " light casts, " : " lights cast, ")
      << in.Cache.GetNumberOfMaps() << " maps of " << in.Maps.GetSize() << " x "
      << in.Maps.GetSize() << " texels, " << this->NumberOfMapsDrawn << " drawn anew"
      << without.str();
  reason = out.str();
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::RenderBefore(vtkRelievoPass*, const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  this->NumberOfMapsDrawn = 0;
  in.View.Take(s->GetRenderer(), s);
  in.Props.Collect(s);
  this->FitMaps(s);
  in.Props.AddPass(this);
  in.Spliced = true;
  this->DrawMaps(s);
  in.Maps.Bind(true);
  in.Told.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::FitMaps(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  vtkRelievoShadowFit::Request request;
  request.Size = this->MapSize;
  const int largest = vtkRelievoShadowMaps::GetLargestSize();
  if (request.Size > largest)
  {
    request.Size = largest;
    if (in.Said.insert("size" + std::to_string(this->MapSize)).second)
    {
      vtkWarningMacro("Shadow maps of " << this->MapSize << " x " << this->MapSize
                                        << " texels were asked for, this OpenGL makes at most "
                                        << largest << " x " << largest << ": these are used.");
    }
  }
  request.Border = this->FilterRadius + 1;
  in.Cache.Update(
    in.Casting, in.Props, in.View.ViewToNDC * in.View.WorldToView, request);
  if (in.Maps.Allocate(window, request.Size, in.Cache.GetNumberOfLayers()))
  {
    in.Cache.Invalidate();
  }
  vtkRelievoShadowSplice::Structure structure;
  structure.Numbers = static_cast<int>(in.Lights.size());
  structure.Unlit = this->LayersAsked;
  structure.WideFilter = this->FilterRadius > 1;
  for (const auto& entry : in.Cache.GetEntries())
  {
    structure.Lights.push_back(
      { entry.Light.ShaderIndex, !entry.Light.Positional, entry.Maps.size() > 1 });
  }
  if (!(structure == in.Structure))
  {
    in.Structure = structure;
    in.StructureTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::DrawMaps(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  in.Told.clear();
  for (auto& entry : in.Cache.GetEntries())
  {
    for (auto& map : entry.Maps)
    {
      if (map.Drawn)
      {
        continue;
      }
      if (!in.DrawingMaps)
      {
        in.DrawingMaps = true;
        in.Maps.Bind(false);
        in.Maps.Begin();
      }
      in.Maps.Draw(map.Layer, map.View, renderer,
        [&]() { this->DrawCalls += in.Props.RenderCasters(renderer, map.View, in.PlainDraw); });
      map.Drawn = true;
      ++this->NumberOfMapsDrawn;
    }
  }
  if (in.DrawingMaps)
  {
    in.Maps.End();
    in.DrawingMaps = false;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::RenderAfter(vtkRelievoPass*, const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  if (in.Spliced)
  {
    in.Props.RemovePass(this);
    in.Maps.Unbind();
    in.Spliced = false;
    if (in.Props.ChangesByDrawing())
    {
      // Some mappers count themselves as modified when they draw.
      in.Props.Collect(s);
      in.Cache.SetCasters(in.Props);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    vtkRelievoShadowSplice::Mark(vertexShader, geometryShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!mapper || !actor)
  {
    return true;
  }
  const std::string missing = vtkRelievoShadowSplice::Fill(
    vertexShader, geometryShader, fragmentShader, mapper, actor, in.Structure);
  if (!missing.empty() && in.Said.insert(mapper->GetClassName() + missing).second)
  {
    vtkErrorMacro("No shadows on what " << mapper->GetClassName() << " draws: " << missing
                                        << ". Use VTK's shader templates, with their tags.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetFrameParameters(vtkShaderProgram* program)
{
  Internals& in = *this->Internal;
  const glm::dmat4 viewToWorld = glm::inverse(in.View.WorldToView);
  // Texels are counted from the centre of the lowest left one.
  const double half = 0.5 * in.Maps.GetSize();
  glm::dmat4 ndcToMap(0.5);
  ndcToMap[0].x = ndcToMap[1].y = half;
  ndcToMap[3] = glm::dvec4(half - 0.5, half - 0.5, 0.5, 1.0);
  const int faces = in.Structure.GetFaces();
  // Where there is no map, every point is outside of it.
  glm::mat4 nowhere(0.f);
  nowhere[3] = glm::vec4(-1e9f, -1e9f, 0.f, 1.f);
  std::vector<glm::mat4> matrices(faces, nowhere);
  std::vector<glm::mat4> planes(faces, glm::mat4(1.f));
  std::vector<glm::vec4> eyes(faces, glm::vec4(0.f));
  std::vector<float> texels(faces, 0.f);
  std::vector<float> layers(faces, 0.f);
  std::vector<float> strengths;
  std::vector<int> slots(in.Structure.Numbers, -1);
  int first = 0;
  for (const auto& entry : in.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    const double strength = this->Strength * light.Light->GetShadowAttenuation();
    int face = first;
    for (const auto& map : entry.Maps)
    {
      const glm::dmat4 viewToMap =
        ndcToMap * map.View.ViewToNDC * (map.View.WorldToView * viewToWorld);
      glm::dmat4 biased = viewToMap;
      biased[3].z -= this->Bias * map.View.Texel;
      matrices[face] = glm::mat4(biased);
      planes[face] = glm::mat4(glm::transpose(glm::inverse(viewToMap)));
      eyes[face] = glm::vec4(
        viewToMap * (in.View.Parallel ? glm::dvec4(0, 0, 1, 0) : glm::dvec4(0, 0, 0, 1)));
      texels[face] = static_cast<float>(map.View.Texel);
      layers[face++] = static_cast<float>(map.Layer);
    }
    first += in.Structure.Lights[strengths.size()].GetRoom();
    slots[light.Number] = static_cast<int>(strengths.size());
    strengths.push_back(this->Visible ? static_cast<float>(strength) : 0.f);
  }
  const int lights = static_cast<int>(strengths.size());
  program->SetUniformi("relievoShadowMaps", in.Maps.GetTextureUnit());
  program->SetUniformMatrix4x4v("relievoShadowMatrix", faces, &matrices[0][0][0]);
  program->SetUniformMatrix4x4v("relievoShadowPlane", faces, &planes[0][0][0]);
  program->SetUniform4fv(
    "relievoShadowEye", faces, reinterpret_cast<const float(*)[4]>(&eyes[0][0]));
  program->SetUniform1fv("relievoShadowTexel", faces, texels.data());
  program->SetUniform1fv("relievoShadowLayer", faces, layers.data());
  program->SetUniform1fv("relievoShadowStrength", lights, strengths.data());
  program->SetUniform1iv("relievoShadowSlot", in.Structure.Numbers, slots.data());
  program->SetUniformf("relievoShadowSize", static_cast<float>(in.Maps.GetSize()));
  program->SetUniformi("relievoShadowRadius", this->FilterRadius);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Spliced || !actor)
  {
    return true;
  }
  if (in.DrawingMaps)
  {
    ++this->DrawCalls;
    in.Lightly.insert(program);
    // A sheet blocks light from both sides.
    in.Maps.DrawBothSides();
  }
  else if (in.Lightly.erase(program))
  {
    // What VTK takes for this frame's uniforms of the lights are a map's.
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  }
  if (!program->IsUniformUsed("relievoShadowMaps"))
  {
    return true;
  }
  if (in.Told.insert(program).second)
  {
    this->SetFrameParameters(program);
  }
  vtkProperty* property = actor->GetProperty();
  program->SetUniformf("relievoShadowInner",
    in.Props.Receives(prop) ? 0.5f * (in.Maps.GetSize() - 1) - this->FilterRadius : -1.f);
  program->SetUniformf("relievoShadowLift",
    std::max(property->GetPointSize(), property->GetLineWidth()));
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoShadowPass::GetShaderStageMTime()
{
  return this->Internal->StructureTime.GetMTime();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowPass::GetBytesHeld()
{
  return this->Internal->Maps.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Maps.Release(window);
  this->Internal->PlainDraw.Release(window);
  this->Internal->Cache.Clear();
  this->NumberOfMapsDrawn = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Visible: " << this->Visible << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Casting lights: " << this->GetNumberOfCastingLights() << "\n";
  os << indent << "Maps: " << this->GetNumberOfMaps() << "\n";
}
