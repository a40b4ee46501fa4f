// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK's mappers ask of the pass.
#include "vtkRelievoShadowInternals.h"

#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRelievoShaderTrial.h"
#include "vtkRelievoShadowUniforms.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Internal->Spliced && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
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
  if (!in.Spliced || !mapper || !actor)
  {
    return true;
  }
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  std::string missing = vtkRelievoShadowSplice::Fill(
    vertexShader, geometryShader, fragmentShader, mapper, actor, in.Work.Structure);
  std::string key = mapper->GetClassName() + missing;
  if (missing.empty())
  {
    key += "compiles not";
    missing = vtkRelievoShaderTrial::Compile(
      in.Window, actor->GetShaderProperty(), vertexShader, geometryShader, fragmentShader);
    if (!missing.empty())
    {
      vertexShader = own[0];
      geometryShader = own[1];
      fragmentShader = own[2];
    }
  }
  // Gaussian splats are known to cast and not to receive: nothing that a user could mend.
  const bool known = mapper->IsA("vtkOpenGLPointGaussianMapperHelper") != 0;
  if (!missing.empty() && !known && in.Said.insert(key).second)
  {
    vtkErrorMacro("No shadows on what " << mapper->GetClassName() << " draws: " << missing << ".");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Spliced || !actor)
  {
    return true;
  }
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper))
  {
    in.Work.PlainDraw.Learn(mapper);
  }
  const bool drawingMaps = in.IsDrawingMaps(program);
  this->DrawCalls += drawingMaps || in.Work.DrawingDepth ? 1 : 0;
  if (drawingMaps)
  {
    // A sheet blocks light from both sides.
    vtkRelievoShadowMaps::DrawBothSides(in.Window);
  }
  if (!program->IsUniformUsed("relievoShadowMaps") &&
    !program->IsUniformUsed("relievoSeenVerdicts"))
  {
    return true;
  }
  if (in.Told.insert(program).second)
  {
    vtkRelievoShadowUniforms::SetFrame(
      program, in.Work, *in.Method, this->Visible ? this->Strength : 0.0);
    in.Method->SetFrameUniforms(program, in.Work);
  }
  vtkRelievoShadowUniforms::SetActor(program, in.Work, actor);
  in.Method->SetActorUniforms(program, in.Work, actor);
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoShadowPass::GetShaderStageMTime()
{
  // Asked outside of its own drawing by keys that were copied meanwhile: there it splices nothing.
  Internals& in = *this->Internal;
  if (!in.Spliced || in.Strayed)
  {
    in.StructureTime.Modified();
    in.Strayed = !in.Spliced;
  }
  return in.StructureTime.GetMTime();
}
