// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass tells VTK's mappers and their shaders.
#include "vtkRelievoGBufferInternals.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRelievoShaderTrial.h"
#include "vtkRelievoSurfaces.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Internal->Writing && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    vtkRelievoGBufferSplice::Mark(vertexShader, geometryShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Writing || !mapper || !actor)
  {
    return true;
  }
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  // Returns what is wrong, in words, and leaves the shaders as they were then.
  auto fill = [&](vtkRelievoGBufferSplice::Mode mode, bool& compiles) {
    mode.Deferred =
      mode.Deferred && actor->GetProperty()->GetLighting() && in.WhyLit(actor).empty();
    std::string wrong = vtkRelievoGBufferSplice::Fill(
      vertexShader, geometryShader, fragmentShader, mapper, actor, in.Layout, mode);
    compiles = true;
    if (wrong.empty())
    {
      wrong = vtkRelievoShaderTrial::Compile(
        static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow()),
        actor->GetShaderProperty(), vertexShader, geometryShader, fragmentShader);
      compiles = wrong.empty();
    }
    if (!wrong.empty())
    {
      vertexShader = own[0];
      geometryShader = own[1];
      fragmentShader = own[2];
    }
    return wrong;
  };
  bool compiles = true;
  std::string wrong = fill(in.Mode, compiles);
  if (!compiles && in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader)
  {
    vtkRelievoGBufferSplice::Mode without = in.Mode;
    without.PrimitiveIds = vtkRelievoPrimitiveIds::Unreliable;
    wrong = fill(without, compiles);
  }
  const std::string name = mapper->GetClassName();
  if (!wrong.empty() && in.Said.insert(name + (compiles ? wrong : "compiles not")).second)
  {
    vtkErrorMacro("No layers of what " << name << " draws: " << wrong << ".");
  }
  const bool numbered = vtkRelievoGBufferSplice::GetPrimitiveSource(mapper, actor) !=
    vtkRelievoGBufferSplice::GetPrimitiveSource(fragmentShader);
  if (wrong.empty() && numbered && in.Layout.IdWord >= 0 &&
    in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader &&
    in.Said.insert(name + "ids").second)
  {
    vtkErrorMacro("No cell ids of what "
      << name << " draws: with this OpenGL they need a geometry shader, which cannot hand on all "
      << "that its vertex shader puts out. Declare one output of a simple type on a line.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Writing || !mapper || !actor)
  {
    return true;
  }
  // Nor into the depth buffer alone (hidden line removal).
  unsigned char mask[4] = { 1, 1, 1, 1 };
  static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetBooleanv(GL_COLOR_WRITEMASK, mask);
  const bool writes = (mask[0] || mask[1] || mask[2] || mask[3]) &&
    program->GetFragmentShader()->GetSource().find("relievoOutput1") != std::string::npos;
  in.Target.WriteLayers(writes);
  if (!writes)
  {
    const bool seen = mask[0] || mask[1] || mask[2] || mask[3];
    in.Stray = in.Stray || (seen && in.Mode.Deferred);
    return true;
  }
  ++this->DrawCalls;
  if (in.Layout.IdWord >= 0)
  {
    const int source =
      vtkRelievoGBufferSplice::GetPrimitiveSource(program->GetFragmentShader()->GetSource());
    const std::uint32_t first = in.Draws.Add(actor, mapper, source);
    if (in.Draws.IsLastAmbiguous() && in.Said.insert("blocks").second)
    {
      vtkErrorMacro("No cell and block ids of some composite data: this VTK gives primitives of "
                    "several of its blocks the same numbers where cells have normals but no "
                    "colours. Colour the cells, or compute the normals at the points.");
    }
    program->SetUniformi("relievoFirstPrimitive", static_cast<int>(first));
    if (first == vtkRelievoDrawTable::Nothing && in.Said.insert("words").second)
    {
      vtkErrorMacro("More primitives are drawn than 32 bits count: what is drawn last has the ids "
                    "-1, no arrays, and depth as the rasteriser rounds it. Draw less at once.");
    }
  }
  in.Glyphs.SetUniforms(program, mapper);
  program->SetUniformi(
    "relievoFaces", actor->GetProperty()->GetRepresentation() == VTK_SURFACE ? 1 : 0);
  if (in.Layout.SurfaceWord >= 0)
  {
    vtkRelievoSurfaces::SetUniforms(program, actor);
    in.CountLeft(program, mapper, actor);
  }
  const double winding = actor->GetMatrix()->Determinant() * in.View.GetWinding();
  program->SetUniformf("relievoWinding", winding < 0.0 ? -1.0f : 1.0f);
  program->SetUniformf("relievoNear", static_cast<float>(in.View.Near));
  program->SetUniformf("relievoFar", static_cast<float>(in.View.Far));
  return true;
}

//------------------------------------------------------------------------------
// Counts the draw among those whose light is left out, or those that VTK lights, and why.
void vtkRelievoGBufferPass::Internals::CountLeft(
  vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  if (!this->Mode.Deferred || !actor->GetProperty()->GetLighting())
  {
    return; // there is nothing to leave out
  }
  auto known = this->LeftOut.find(program);
  if (known == this->LeftOut.end())
  {
    const std::string fragment = program->GetFragmentShader()->GetSource();
    const bool out = fragment.find("#define RELIEVO_LIGHT_LEFT_OUT") != std::string::npos;
    std::string why = out ? std::string() : this->WhyLit(actor);
    why = out || !why.empty() ? why : vtkRelievoSurfaces::WhyLit(mapper, fragment);
    why = out || !why.empty() ? why : "has no light in its shader as VTK writes it";
    known = this->LeftOut.emplace(program, why).first;
  }
  ++(known->second.empty() ? this->Textures.Deferred : this->Textures.Left[known->second]);
}

//------------------------------------------------------------------------------
// Why VTK has to light the actor: for itself, or for another one that shares its mapper's shaders.
std::string vtkRelievoGBufferPass::Internals::WhyLit(vtkActor* actor) const
{
  const auto found = this->Lit.find(actor->GetMapper());
  return found != this->Lit.end() ? found->second
                                  : vtkRelievoSurfaces::WhyLit(actor, this->Renderer);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoGBufferPass::GetShaderStageMTime()
{
  // Asked outside of its own drawing by keys that were copied meanwhile: there it splices nothing.
  // Where actors take turns in a mapper's shaders, each needs its own.
  Internals& in = *this->Internal;
  if (!in.Writing || in.Strayed || in.Alternating)
  {
    in.StructureTime.Modified();
    in.Strayed = !in.Writing;
  }
  return in.StructureTime.GetMTime();
}
