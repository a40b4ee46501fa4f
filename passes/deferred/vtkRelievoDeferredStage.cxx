// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDeferredStage.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoShading.h"
#include "vtkRelievoTellVolumes.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkShaderProgram.h"

#include <vector>

vtkStandardNewMacro(vtkRelievoDeferredStage);

namespace
{
// VTK's declarations of its lights, and the calls for each in shaders/deferred/shadeFS.glsl.
std::string DescribeLights(const vtkRelievoFrameContext& context)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(context.Renderer);
  std::string text = renderer->GetLightingUniforms();
  text += "\n#define RELIEVO_LIGHTS";
  const int complexity = renderer->GetLightingComplexity();
  for (const vtkRelievoFrameLight& light : vtkRelievoFrameScene::FindLights(renderer))
  {
    if (light.ShaderIndex < 0)
    {
      continue;
    }
    const auto name = [&light](const char* of) {
      return std::string("light") + of + std::to_string(light.ShaderIndex) + ", ";
    };
    text += complexity == vtkOpenGLRenderer::Headlight ? " RELIEVO_HEADLIGHT(" + name("Color")
      : complexity == vtkOpenGLRenderer::Directional
      ? " RELIEVO_SUN(" + name("Color") + name("DirectionVC")
      : " RELIEVO_LAMP(" + name("Color") + name("DirectionVC") + name("PositionVC") +
        name("Attenuation") + name("Positional") + name("Exponent") + name("ConeAngle");
    text += std::to_string(light.Number) + ")";
  }
  text += "\n";
#ifdef RELIEVO_VTK_PBR_SUNS_AT_PLACES
  text += "#define RELIEVO_PBR_SUNS_AT_PLACES\n";
#endif
  return text;
}
}

class vtkRelievoDeferredStage::Internals
{
public:
  vtkRelievoScreenQuad Quad;
  vtkRelievoReportOnce Reported;
  bool Done = false; // whether the lights were added in this frame
};

//------------------------------------------------------------------------------
vtkRelievoDeferredStage::vtkRelievoDeferredStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoDeferredStage::~vtkRelievoDeferredStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "deferred";
  description.Label = "Deferred Shading";
  description.Help = "Shades opaque surfaces once for each pixel, after they are drawn.";
  description.Slot = vtkRelievoStageDescription::SURFACES;
  description.Reads = { vtkRelievoResources::Shading };
  description.Writes = { vtkRelievoResourceName::Of("shaded") };
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  declaration.DrawsWithDelegate = true;
}

//------------------------------------------------------------------------------
bool vtkRelievoDeferredStage::Prepare(vtkRelievoFrameContext&)
{
  this->Internal->Done = false;
  this->DrawCalls = this->NumberDeferred = this->NumberLeft = 0;
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::EndOpaque(vtkRelievoFrameContext& context)
{
  if (!this->Internal->Done && context.Find(vtkRelievoResources::Shading))
  {
    this->AddLights(context);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::Execute(vtkRelievoFrameContext& context)
{
  const auto* shading = static_cast<vtkRelievoShading*>(context.Find(vtkRelievoResources::Shading));
  if (!shading)
  {
    this->Explain("failed", "the layers could not be made, so VTK lights all surfaces");
    return;
  }
  if (!this->Internal->Done && shading->Deferred > 0)
  {
    this->AddLights(context); // later than usual; from the next frame on VTK lights the surfaces
  }
  std::string words = "shades the surfaces of " + std::to_string(this->NumberDeferred) +
    (this->NumberDeferred == 1 ? " draw call" : " draw calls");
  if (!shading->WhyNot.empty())
  {
    this->Explain("idle", "VTK lights all surfaces, since " + shading->WhyNot);
    return;
  }
  for (const auto& left : shading->Left)
  {
    words += "; VTK lights " + std::to_string(left.second) +
      (left.second == 1 ? " that " : ", each of which ") + left.first;
  }
  this->Explain("ran", words + vtkRelievoTellVolumes(context, "lit by VTK"));
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::AddLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  auto* shading = static_cast<vtkRelievoShading*>(context.Find(vtkRelievoResources::Shading));
  in.Done = true;
  this->NumberDeferred = shading->Deferred;
  for (const auto& left : shading->Left)
  {
    this->NumberLeft += left.second;
  }
  if (this->NumberDeferred == 0)
  {
    return;
  }
  auto* renderer = static_cast<vtkOpenGLRenderer*>(context.Renderer);
  std::vector<vtkRelievoResourceName> reads{ vtkRelievoResources::Shading };
  if (shading->NumberOfLights > 0 && context.Find(vtkRelievoResources::ShadowMaps))
  {
    reads.push_back(vtkRelievoResources::ShadowMaps);
  }
  vtkShaderProgram* program =
    in.Quad.Ready(context, "deferred/shadeFS.glsl", reads, DescribeLights(context));
  if (!program)
  {
    if (in.Reported.IsNew(in.Quad.GetError()))
    {
      vtkErrorMacro("Surfaces are not lit: " << in.Quad.GetError() << ".");
    }
    return;
  }
  // Another renderer's lights may be newer, and VTK's shader cache gives both renderers one
  // program.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  renderer->UpdateLightingUniforms(program);
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  in.Quad.Draw(context);
  ++this->DrawCalls;
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoDeferredStage::GetFacts()
{
  return { { "deferred_draws", vtkVariant(this->NumberDeferred) },
    { "forward_draws", vtkVariant(this->NumberLeft) } };
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Quad.Release(window);
  this->DrawCalls = this->NumberDeferred = this->NumberLeft = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoDeferredStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberDeferred: " << this->NumberDeferred << "\n";
  os << indent << "NumberLeft: " << this->NumberLeft << "\n";
}
