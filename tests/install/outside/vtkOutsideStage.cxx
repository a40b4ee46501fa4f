// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOutsideStage.h"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkRelievoFrameContext.h>
#include <vtkRelievoPropParts.h>
#include <vtkRelievoShaderLibrary.h>
#include <vtkRelievoStageRegistry.h>
#include <vtkRenderState.h>
#include <vtkShaderProgram.h>

vtkStandardNewMacro(vtkOutsideStage);

namespace
{
const bool Registered =
  vtkRelievoStageRegistry::Add([]() -> vtkRelievoStage* { return vtkOutsideStage::New(); });

const bool Added = vtkRelievoShaderLibrary::Add("outside/timesFS.glsl", R"(//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(frame/color.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform float factor;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
  gl_FragData[0] = isinf(relievoFetchDepth(pixel)) ? color : vec4(factor * color.rgb, color.a);
}
)");
}

//------------------------------------------------------------------------------
void vtkOutsideStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "times";
  description.Help = "Multiplies the colour of what is seen.";
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::Color };
  description.Writes = { vtkRelievoResources::Color };
  description.AddNumber(
    "factor", this->Factor, [this](double f) { this->SetFactor(f); }, 0.0, 10.0, "", "Times this.");
}

//------------------------------------------------------------------------------
bool vtkOutsideStage::Prepare(vtkRelievoFrameContext& context)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    vtkRelievoPropParts::Collect(context.State->GetPropArray()[i], parts);
  }
  this->NumberOfMeshes = 0;
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    if (vtkActor* mesh = vtkRelievoPropParts::GetMeshActor(part))
    {
      this->Spliced.Add(mesh, this);
      ++this->NumberOfMeshes;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkOutsideStage::Finish(vtkRelievoFrameContext&)
{
  this->Spliced.Remove(this);
}

//------------------------------------------------------------------------------
void vtkOutsideStage::Execute(vtkRelievoFrameContext& context)
{
  vtkShaderProgram* program = Registered && Added
    ? this->Quad.Ready(
        context, "outside/timesFS.glsl", { vtkRelievoResources::Depth, vtkRelievoResources::Color })
    : nullptr;
  if (!program)
  {
    this->Explain("failed", this->Quad.GetError());
    return;
  }
  program->SetUniformf("factor", static_cast<float>(this->Factor));
  context.DrawColor(this->Quad);
  this->Explain("ran", "meshes: " + std::to_string(this->NumberOfMeshes));
}

//------------------------------------------------------------------------------
void vtkOutsideStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
