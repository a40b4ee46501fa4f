// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTranslucentLamps.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoThreads.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

using namespace vtkRelievoSpliceText;

vtkStandardNewMacro(vtkRelievoTranslucentLamps);

namespace
{
const char* const File = "deferred/translucent.glsl";
const char* const Extensions = "//RELIEVO::Lamps::Extensions";
const char* const Dec = "//RELIEVO::Lamps::Dec";
const char* const Impl = BehindLight[4];
}

//------------------------------------------------------------------------------
std::string vtkRelievoTranslucentLamps::Begin(
  vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, bool all)
{
  this->NumberOfProps = 0;
  this->View = context.View;
  std::vector<vtkProp*> props = vtkRelievoShadowCatcher::Find(context);
  for (int i = 0; all && i < context.State->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = context.State->GetPropArray()[i];
    if (!vtkRelievoShadowCatcher::Is(prop) && prop->HasTranslucentPolygonalGeometry())
    {
      props.push_back(prop);
    }
  }
  if (!props.empty())
  {
    vtkRelievoWithThreads([&]() {
      this->List.Take(this->View, sets);
      this->Clusters.Build(this->View, this->List);
    });
  }
  if (props.empty() || this->List.GetLamps().empty())
  {
    this->ReleaseGraphicsResources(context.Window);
    return {};
  }
  std::string error = this->Lamps.Upload(context.Window, this->List.GetTexels(), 4);
  const auto upload = [&](
                        vtkRelievoTextureBuffer& buffer, const std::vector<float>& values, int n) {
    error = error.empty() ? buffer.Upload(context.Window, values, n) : error;
  };
  upload(this->Attenuations, this->List.GetAttenuations(), 4);
  upload(this->Cells, this->Clusters.GetCells(), 1);
  upload(this->Lists, this->Clusters.GetLists(), 1);
  if (!error.empty())
  {
    return error;
  }
  if (this->Parallel != this->View.Parallel)
  {
    this->Parallel = this->View.Parallel;
    this->ModifyShaders();
  }
  this->Window = context.Window;
  for (vtkProp* prop : props)
  {
    this->Keys.Add(prop, this);
  }
  this->NumberOfProps = static_cast<int>(props.size());
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLamps::End()
{
  if (this->Window)
  {
    this->Keys.Remove(this);
    for (vtkRelievoTextureBuffer* buffer :
      { &this->Lamps, &this->Attenuations, &this->Cells, &this->Lists })
    {
      buffer->Deactivate();
    }
  }
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentLamps::IsSplicing() const
{
  return this->Window != nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLamps::MarkShaders(const vtkRelievoShaderTexts& shaders)
{
  MarkVaryings(shaders.Vertex, shaders.Geometry, shaders.Fragment);
  MarkBehind(shaders.Fragment, "//VTK::System::Dec", Extensions);
  MarkBehind(shaders.Fragment, "//VTK::Light::Dec", Dec);
  MarkBehindLight(shaders.Fragment, Impl);
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLamps::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  std::string& fragment = shaders.Fragment;
  if (!Has(fragment, "normalVCVSOutput") || !Has(fragment, Extensions) || !Has(fragment, Dec) ||
    !Has(fragment, Impl))
  {
    return; // an unlit surface
  }
  const auto fill = [&]() -> std::string {
    if (!EnsurePosition(shaders.Vertex, shaders.Geometry, fragment))
    {
      return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's "
             "templates";
    }
    std::string defines = this->Parallel ? "#define RELIEVO_LINEAR_SLICES\n" : "";
    defines += Has(fragment, "vec3 albedo =") ? "#define RELIEVO_LAMPS_ON_PBR\n" : "";
    defines +=
      Has(fragment, "float diffuseIntensityBF;") ? "#define RELIEVO_LAMPS_ON_BACKFACES\n" : "";
    FillMark(fragment, Extensions, defines);
    FillMark(fragment, Dec, vtkRelievoShaderLibrary::GetSection(File, "Dec"));
    FillMark(fragment, Impl, vtkRelievoShaderLibrary::GetSection(File, "Impl"));
    return {};
  };
  const vtkRelievoTrialSplice::Outcome outcome = TrySplice(shaders, this->Window, actor, fill);
  if (this->IsNews(mapper, outcome))
  {
    vtkErrorMacro("Lamps do not light the translucent surfaces of "
      << mapper->GetClassName() << ": " << outcome.Error << ".");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentLamps::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!this->Window || !actor || !program->IsUniformUsed("relievoLampsLight"))
  {
    return true;
  }
  // The stage itself lights the actor's opaque surfaces.
  const bool light =
    actor->IsRenderingTranslucentPolygonalGeometry() && actor->GetProperty()->GetLighting();
  program->SetUniformi("relievoLampsLight", light ? 1 : 0);
  program->SetUniformi("relievoLampsCaught", vtkRelievoShadowCatcher::Is(actor) ? 1 : 0);
  this->Lamps.Activate(program, "relievoLamps");
  this->Attenuations.Activate(program, "relievoLampAttenuations");
  this->Cells.Activate(program, "relievoCells");
  this->Lists.Activate(program, "relievoLists");
  this->Clusters.SetUniforms(program);
  glm::mat4 projection = this->View.GetProjection();
  const float pixels[2] = { static_cast<float>(this->View.Viewport[2]),
    static_cast<float>(this->View.Viewport[3]) };
  program->SetUniformMatrix4x4("relievoLampProjection", &projection[0][0]);
  program->SetUniform2f("relievoLampPixels", pixels);
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoTranslucentLamps::GetBytes() const
{
  return this->Lamps.GetBytes() + this->Attenuations.GetBytes() + this->Cells.GetBytes() +
    this->Lists.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLamps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->End();
  for (vtkRelievoTextureBuffer* buffer :
    { &this->Lamps, &this->Attenuations, &this->Cells, &this->Lists })
  {
    buffer->Release(window);
  }
  this->NumberOfProps = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
