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
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoTrialCompile.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

using namespace vtkRelievoSpliceText;

vtkStandardNewMacro(vtkRelievoTranslucentLamps);

namespace
{
const char* const File = "deferred/translucent.glsl";
const char* const Extensions = "//RELIEVO::Lamps::Extensions";
const char* const Dec = "//RELIEVO::Lamps::Dec";
const char* const Impl = "//RELIEVO::Lamps::Impl";
}

//------------------------------------------------------------------------------
std::string vtkRelievoTranslucentLamps::Begin(
  vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets)
{
  this->NumberOfProps = 0;
  this->View = context.View;
  std::vector<vtkProp*> props;
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = context.State->GetPropArray()[i];
    if (prop->HasTranslucentPolygonalGeometry())
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
  std::string wrong = this->Lamps.Upload(context.Window, this->List.GetTexels(), 4);
  const auto upload = [&](
                        vtkRelievoTextureBuffer& buffer, const std::vector<float>& values, int n) {
    wrong = wrong.empty() ? buffer.Upload(context.Window, values, n) : wrong;
  };
  upload(this->Attenuations, this->List.GetAttenuations(), 4);
  upload(this->Cells, this->Clusters.GetCells(), 1);
  upload(this->Lists, this->Clusters.GetLists(), 1);
  if (!wrong.empty())
  {
    return wrong;
  }
  if (this->Parallel != this->View.Parallel)
  {
    this->Parallel = this->View.Parallel;
    this->StructureTime.Modified();
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
bool vtkRelievoTranslucentLamps::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Window && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    MarkVaryings(vertexShader, geometryShader, fragmentShader);
    MarkBehind(fragmentShader, "//VTK::System::Dec", Extensions);
    MarkBehind(fragmentShader, "//VTK::Light::Dec", Dec);
    MarkBehind(fragmentShader, "//VTK::Light::Impl", Impl);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentLamps::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool lit = Has(fragmentShader, "normalVCVSOutput") && Has(fragmentShader, Extensions) &&
    Has(fragmentShader, Dec) && Has(fragmentShader, Impl);
  if (!this->Window || !actor || !lit)
  {
    return true;
  }
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  std::string wrong = EnsurePosition(vertexShader, geometryShader, fragmentShader)
    ? std::string()
    : "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's templates";
  if (wrong.empty())
  {
    std::string defines = this->Parallel ? "#define RELIEVO_LINEAR_SLICES\n" : "";
    defines += Has(fragmentShader, "vec3 albedo =") ? "#define RELIEVO_LAMPS_ON_PBR\n" : "";
    defines += Has(fragmentShader, "float diffuseIntensityBF;")
      ? "#define RELIEVO_LAMPS_ON_BACKFACES\n"
      : "";
    FillMark(fragmentShader, Extensions, defines);
    FillMark(fragmentShader, Dec, vtkRelievoShaderLibrary::GetSection(File, "Dec"));
    FillMark(fragmentShader, Impl, vtkRelievoShaderLibrary::GetSection(File, "Impl"));
    wrong = vtkRelievoTrialCompile::Compile(
      this->Window, actor->GetShaderProperty(), vertexShader, geometryShader, fragmentShader);
  }
  if (!wrong.empty())
  {
    vertexShader = own[0];
    geometryShader = own[1];
    fragmentShader = own[2];
    if (this->Reported.insert(mapper->GetClassName() + wrong).second)
    {
      vtkErrorMacro("No light of lamps on what " << mapper->GetClassName()
                                                 << " draws translucent: " << wrong << ".");
    }
  }
  return true;
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
  // What an actor draws opaque is lit by the stage.
  const bool light =
    actor->IsRenderingTranslucentPolygonalGeometry() && actor->GetProperty()->GetLighting();
  program->SetUniformi("relievoLampsLight", light ? 1 : 0);
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
vtkMTimeType vtkRelievoTranslucentLamps::GetShaderStageMTime()
{
  // Asked outside of Begin and End by keys that were copied meanwhile: there it splices nothing.
  if (!this->Window || this->BuiltUnspliced)
  {
    this->StructureTime.Modified();
    this->BuiltUnspliced = !this->Window;
  }
  return this->StructureTime.GetMTime();
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
