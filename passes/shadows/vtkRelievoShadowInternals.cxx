// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowInternals.h"

#include "vtkActor.h"

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Internals::UseMethod(int method, vtkOpenGLRenderWindow* window)
{
  if (method == this->MethodMade)
  {
    return;
  }
  this->Method = vtkRelievoShadowMethod::Make(method);
  this->MethodMade = method;
  this->Work.Cache.Refit();
  window->MakeCurrent(); // what the one before held may have been another window's
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Internals::UpdateStructure()
{
  vtkRelievoShadowSplice::Structure structure;
  structure.Method = this->Method->GetShader();
  structure.Traced = this->Method->Traces();
  structure.Colored = this->Method->Colors();
  structure.Maps = !structure.Traced || this->Work.Cache.GetNumberOfMaps() > 0;
  structure.Numbers = static_cast<int>(this->Lights.GetAll().size());
  structure.Unlit = this->LayersAsked;
  structure.WideFilter = this->Work.Radius > 1;
  for (const auto& entry : this->Work.Cache.GetEntries())
  {
    structure.Lights.push_back({ entry.Light.ShaderIndex, !entry.Light.Positional, entry.Cube });
  }
  for (vtkActor* actor : this->Method->GetFound(structure.Lights.size()))
  {
    structure.Found.emplace_back(actor, actor->GetMapper());
  }
  if (!(structure == this->Work.Structure))
  {
    this->Work.Structure = structure;
    this->StructureTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::Internals::IsDrawingMaps(vtkShaderProgram* program)
{
  if (this->Work.DrawingMaps)
  {
    this->Schedule.AddProgram(program);
  }
  if (this->Lamps.Work.DrawingMaps)
  {
    this->Lamps.Schedule.AddProgram(program);
  }
  return this->Work.DrawingMaps || this->Lamps.Work.DrawingMaps;
}
