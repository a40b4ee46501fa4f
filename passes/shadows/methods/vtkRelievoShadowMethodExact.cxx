// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodExact.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRelievoMeshExchange.h"
#include "vtkRelievoMeshMessage.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMethodMap.h"
#include "vtkRelievoShadowRegion.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace
{
// The share of wrong verdicts that testShadowExact allows, for any map size.
constexpr vtkRelievoShadowErrorLaw ExactLaw = { 2e-5, 0.0 };

// Additional share where floats lack digits: testShadowStability has 0.11 % at a farness of 27000,
// and 0.02 % at 3800. Corners are rounded twice, in VTK's buffer and in the rasterisation:
// certificates have 2.5 % where coordinates of a caster reach 400000 times as far as the view.
constexpr double FarLaw = 5e-8;
constexpr double CornerRoundings = 2.0;

// Additional share for dense edges: OpenGL places corners in steps of 1/256 of a pixel, which
// decides the side of an edge so close to a pixel's centre. Edges within half a pixel are 128 times
// as many. Fitted to docs/charts/shadows/exact-hard.csv. Rounding by more than a step counts
// proportionally.
constexpr double Steps = 256.0;
constexpr double EdgeLaw = 0.6 / Steps;

// Number of roundings of a place from the vertex buffer through the camera's matrix to the raster.
constexpr double Roundings = 4.0;
constexpr double Ulp = 1.0 / (1 << 23);

// Half of the picture's height in world units at a point.
double GetSizeInView(const vtkRelievoFrameCamera& view, const glm::dvec3& center)
{
  const double away = -(view.WorldToView * glm::dvec4(center, 1.0)).z;
  return (view.Parallel ? 1.0 : std::abs(away)) / std::abs(view.ViewToNDC[1][1]);
}

// The error of places rounded at this distance, in pixels of a picture of this height.
double GetPixels(double farness, int height)
{
  return 0.5 * Ulp * farness * height;
}

// The centre of the visible parts of the receivers.
glm::dvec3 GetCenter(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoBox>& receivers)
{
  return vtkRelievoShadowRegion::GetMiddle(
    vtkRelievoShadowRegion::Cut(receivers, view.ViewToNDC * view.WorldToView));
}

bool IsOfGlyphs(vtkActor* actor)
{
  return vtkGlyph3DMapper::SafeDownCast(actor->GetMapper()) != nullptr;
}

// A point near it, on a grid about as wide as the view: few camera moves change it.
glm::dvec3 GetOrigin(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoBox>& receivers)
{
  const glm::dvec3 center = GetCenter(view, receivers);
  const double size = GetSizeInView(view, center);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return center;
  }
  const double step = std::exp2(std::ceil(std::log2(size)));
  return step * glm::round(center / step);
}
}

//------------------------------------------------------------------------------
double vtkRelievoShadowMethodExact::GetFarness(const vtkRelievoShadowContext& work, double reach)
{
  // With several processes, the receivers of all.
  const std::vector<vtkRelievoBox>& others = work.Others.GetWhole().Receivers;
  const glm::dvec3 center =
    GetCenter(work.View, others.empty() ? work.Props.GetReceiverBoxes() : others);
  const double size = GetSizeInView(work.View, center);
  const glm::dvec3 toEye(work.View.WorldToView * glm::dvec4(center, 1.0));
  double away = std::max(CornerRoundings * reach, glm::length(toEye));
  for (const auto* boxes : { &work.Props.GetAllBoxes(), &others })
  {
    for (const vtkRelievoBox& box : *boxes)
    {
      away = std::max(away, glm::length(glm::clamp(center, box.Min, box.Max) - center));
    }
  }
  return size > 0.0 && std::isfinite(away / size) ? away / size : 0.0;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowMethodExact::Prepare(
  vtkRelievoShadowContext& work, vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoMeshPart part;
  part.Meshes = work.Props.Follow();
  part.Receivers = work.Props.GetReceiverBoxes();
  part.InMaps = work.Props.GetCasterBoxes(true);
  this->InMaps = part.InMaps.size();
  std::string fault;
  if (work.Others.IsOn())
  {
    const glm::dvec3 origin = GetOrigin(work.View, work.Others.GetWhole().Receivers);
    const bool ready =
      this->Tree.IsIn(window, origin) && this->Tree.Bind() && this->Seen.TakeUnits(window);
    fault = work.Others.Share(part, ready);
    if (!fault.empty())
    {
      return fault;
    }
    part = work.Others.GetWhole();
  }
  fault = this->Tree.Update(window, part.Meshes, GetOrigin(work.View, part.Receivers));
  this->Colored = fault.empty() && work.ColoredShadows && this->Tree.HasColors();
  const vtkRelievoVisibilityPrepass::Kind kind = this->Colored ? vtkRelievoVisibilityPrepass::Colors
    : this->Tree.HasTranslucent()                              ? vtkRelievoVisibilityPrepass::Shares
                                                               : vtkRelievoVisibilityPrepass::Whole;
  if (fault.empty() && !(this->Tree.Bind() && this->Seen.Begin(window, work.View, kind)))
  {
    fault = "all texture units of this OpenGL are taken";
  }
  if (work.Others.IsOn())
  {
    fault = work.Others.Confirm(fault);
  }
  double reach = 0.0;
  for (const vtkRelievoPlacedMesh& mesh : part.Meshes)
  {
    reach = std::max(reach, vtkRelievoPropMeshes::GetRoundedReach(mesh));
  }
  this->Farness = GetFarness(work, reach);
  this->Rounding = GetPixels(this->Farness, work.View.Viewport[3]);
  work.WithoutFollowed = fault.empty();
  this->Surfaces.clear();
  this->Found.clear();
  if (fault.empty())
  {
    this->Alone = work.OwnSteps && !work.Others.IsOn() && window->GetMultiSamples() <= 1;
    this->FindSurfaces(work);
  }
  return fault;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::FindSurfaces(const vtkRelievoShadowContext& work)
{
  for (vtkProp* prop : work.Props.GetSeen())
  {
    vtkActor* actor = work.PlainDraw.GetSurface(prop);
    vtkProperty* property = actor ? actor->GetProperty() : nullptr;
    if (actor && actor->HasOpaqueGeometry() && !property->GetBackfaceCulling() &&
      !property->GetFrontfaceCulling())
    {
      this->Surfaces.push_back(actor);
    }
  }
  this->Found = this->Surfaces;
  std::vector<vtkRelievoPlacedMesh> glyphs = work.Props.GetSeenGlyphs();
  for (const vtkRelievoPlacedMesh& each : glyphs)
  {
    this->Found.push_back(each.Actor);
  }
  // A mapper has one shader for all of its actors.
  const std::set<vtkProp*> plain(this->Found.begin(), this->Found.end());
  std::set<vtkMapper*> others;
  for (vtkProp* part : work.Props.GetParts())
  {
    auto* actor = vtkActor::SafeDownCast(part);
    if (actor && plain.count(actor) == 0)
    {
      others.insert(actor->GetMapper());
    }
  }
  const auto isOther = [&](vtkActor* actor) { return others.count(actor->GetMapper()) > 0; };
  const auto leave = [](auto& list, auto&& isOut) {
    list.erase(std::remove_if(list.begin(), list.end(), isOut), list.end());
  };
  leave(this->Surfaces, isOther);
  leave(glyphs, [&](const vtkRelievoPlacedMesh& mesh) { return isOther(mesh.Actor); });
  const bool all = this->Seen.SetGlyphs(glyphs);
  leave(
    this->Found, [&](vtkActor* actor) { return isOther(actor) || (!all && IsOfGlyphs(actor)); });
}

//------------------------------------------------------------------------------
std::vector<vtkActor*> vtkRelievoShadowMethodExact::GetFound(std::size_t lights) const
{
  return this->Alone && lights <= static_cast<std::size_t>(this->Seen.GetMostLights())
    ? this->Found
    : std::vector<vtkActor*>();
}

//------------------------------------------------------------------------------
vtkRelievoShadowMethodExact::Rays vtkRelievoShadowMethodExact::GetRays(
  const vtkRelievoShadowContext& work) const
{
  Rays rays;
  // The centre in eye space, rounded to float like vtkRelievoShadowUniforms' value for the shader.
  const glm::dvec3& center = work.Cache.GetCenter();
  rays.Center = glm::vec3(work.View.WorldToView * glm::dvec4(center, 1.0));
  const glm::dmat4 viewToWorld = glm::inverse(work.View.WorldToView);
  glm::dmat4 toLocal{ glm::dmat3(viewToWorld) };
  toLocal[3] = glm::dvec4(
    glm::dvec3(viewToWorld * glm::dvec4(glm::dvec3(rays.Center), 1.0)) - this->Tree.GetOrigin(),
    1.0);
  rays.ToLocal = glm::mat4(toLocal);
  rays.Blur = glm::vec2(Roundings * Ulp * GetSizeInView(work.View, center), Roundings * Ulp);
  for (const auto& entry : work.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    rays.Sources.emplace_back(light.Positional
        ? glm::dvec4(light.Position - this->Tree.GetOrigin(), 1.0)
        : glm::dvec4(-light.Direction, 0.0));
  }
  return rays;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::Tell(
  vtkShaderProgram* program, const Rays& rays, bool walks) const
{
  program->SetUniformi("relievoTree", this->Tree.GetTextureUnit());
  program->SetUniformi("relievoTreeNodes", walks ? this->Tree.GetNumberOfNodes() : 0);
  program->SetUniformi("relievoTreeRecords", this->Tree.GetFirstRecord());
  program->SetUniformMatrix4x4("relievoShadowToLocal", const_cast<float*>(&rays.ToLocal[0][0]));
  program->SetUniform2f("relievoTreeBlur", &rays.Blur.x);
}

//------------------------------------------------------------------------------
int vtkRelievoShadowMethodExact::Draw(vtkRelievoShadowContext& work, vtkRenderer*)
{
  const Rays rays = this->GetRays(work);
  std::vector<double> state(&rays.ToLocal[0][0], &rays.ToLocal[0][0] + 16);
  state.insert(state.end(), &rays.Center.x, &rays.Center.x + 3);
  state.insert(state.end(), &rays.Blur.x, &rays.Blur.x + 2);
  const int calls = this->Seen.DrawSurfaces(this->Surfaces, work.PlainDraw);
  const vtkRelievoVisibilityPrepass::Past past{ this->Tree.GetVersion(),
    this->Tree.HasOnlyMoved() ? &this->Tree.GetMoved() : nullptr };
  return calls + this->Seen.DrawVerdicts(rays.Sources, state, past, [&](vtkShaderProgram* program) {
    this->Tell(program, rays, true);
    program->SetUniform3f("relievoShadowCenter", &rays.Center.x);
  });
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::SetFrameUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowContext& work) const
{
  const Rays rays = this->GetRays(work);
  this->Tell(program, rays, !work.DrawingAnyMaps);
  program->SetUniform4fv("relievoShadowSource", static_cast<int>(rays.Sources.size()),
    reinterpret_cast<const float(*)[4]>(&rays.Sources[0].x));
  this->Seen.SetUniforms(program);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::SetVolumeUniforms(vtkShaderProgram* program,
  const vtkRelievoShadowContext& work, const glm::dmat4& placeToView) const
{
  this->SetFrameUniforms(program, work);
  glm::dmat4 toLocal = glm::inverse(work.View.WorldToView) * placeToView;
  toLocal[3] -= glm::dvec4(this->Tree.GetOrigin(), 0.0);
  const glm::mat4 rounded(toLocal);
  program->SetUniformMatrix4x4("relievoShadowToLocal", const_cast<float*>(&rounded[0][0]));
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::SetActorUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowContext&, vtkActor* actor) const
{
  this->Seen.SetActorUniforms(program, actor);
}

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodExact::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  // The triangles add 56 bytes each.
  estimate.Bytes = vtkRelievoVisibilityPrepass::GetBytes(demand.Width, demand.Height);
  const double farness = std::max(this->Farness, demand.Farness);
  estimate.WrongShare = std::min(1.0,
    std::max({ ExactLaw.GetShare(demand.MapSize), FarLaw * farness,
      EdgeLaw * demand.EdgeShare * (1.0 + Steps * GetPixels(farness, demand.Height)) }));
  if (this->InMaps > 0)
  {
    estimate.WrongShare =
      std::max(estimate.WrongShare, vtkRelievoShadowMethodMap().Estimate(demand).WrongShare);
  }
  return estimate;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowMethodExact::GetReport() const
{
  std::ostringstream out;
  out << ", rays past " << this->Tree.GetNumberOfTriangles() << " triangles of "
      << this->Tree.GetNumberOfCasters()
      << (this->Tree.GetNumberOfCasters() == 1 ? " caster" : " casters");
  if (this->Tree.GetNumberOfGlyphs() > 0)
  {
    out << " at the places of " << this->Tree.GetNumberOfGlyphs() << " glyphs";
  }
  if (this->Rounding > 0.25)
  {
    out << "; coordinates are rounded by up to " << std::setprecision(2) << this->Rounding
        << std::setprecision(6) << " pixels, with more errors at dense edges";
  }
  if (this->InMaps > 0)
  {
    out << "; " << this->InMaps << (this->InMaps == 1 ? " prop" : " props")
        << " that cannot be followed in maps";
  }
  return out.str();
}
