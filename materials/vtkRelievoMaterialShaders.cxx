// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of vtkRelievoMaterial that VTK's mappers call: its text in their shaders, its uniforms.
#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoMaterialAccess.h"
#include "vtkRelievoMaterialEye.h"
#include "vtkRelievoMaterialInternals.h"
#include "vtkRelievoReflection.h"
#include "vtkRelievoShaderTrial.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->GetShaderStageMTime(); // a mapper's first shader is made without asking
    vtkRelievoMaterialSplice::Mark(vertexShader, geometryShader, fragmentShader);
    vtkRelievoReflection::Mark(fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool maps = in.Structure.NormalMap || in.Structure.HeightMap;
  const bool mirrors = in.EnvironmentStructure.Projection != 0;
  if (!mapper || !actor || (!maps && !mirrors) ||
    !vtkRelievoMaterialAccess::DrawsTriangles(mapper) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return true;
  }
  auto say = [&](const char* what, const std::string& missing, bool compiles = true) {
    const std::string key = mapper->GetClassName() + (compiles ? missing : "compiles not");
    if (!missing.empty() && in.Said.insert(key).second)
    {
      vtkErrorMacro(
        "No " << what << " on what " << mapper->GetClassName() << " draws: " << missing << ".");
    }
  };
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  std::string missing;
  if (vtkOpenGLGlyph3DHelper::SafeDownCast(mapper))
  {
    missing = "glyphs carry no maps";
  }
  else if (vtkRelievoMaterialAccess::GetComponents(mapper, "tcoord") < 2)
  {
    missing = "its mesh has no texture coordinates of two components; vtkRelievoTextureCoordinates "
              "makes some";
  }
  else if (vtkRelievoMaterialAccess::ColorsByTexture(mapper))
  {
    missing = "InterpolateScalarsBeforeMapping takes the texture coordinates for colours; switch "
              "it off";
  }
  if (maps && missing.empty())
  {
    missing = vtkRelievoMaterialSplice::Fill(vertexShader, geometryShader, fragmentShader,
      in.Structure, vtkRelievoMaterialAccess::GetComponents(mapper, "tangentMC") == 3);
  }
  if (maps)
  {
    say("maps", missing);
  }
  if (mirrors)
  {
    say("environment",
      vtkRelievoReflection::Fill(
        vertexShader, geometryShader, fragmentShader, in.EnvironmentStructure));
  }
  vtkRenderer* renderer = this->FindRenderer(prop);
  if (renderer && fragmentShader != own[2])
  {
    missing = vtkRelievoShaderTrial::Compile(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), actor->GetShaderProperty(),
      vertexShader, geometryShader, fragmentShader);
    if (!missing.empty())
    {
      vertexShader = own[0];
      geometryShader = own[1];
      fragmentShader = own[2];
      say(maps ? "maps" : "environment", missing, false);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoMaterial::FindRenderer(vtkProp* prop)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = vtkRelievoMaterialEye::FindRenderer(prop);
  // Levels of detail (vtkLODActor, ParaView) are drawn by an actor that belongs to nothing.
  for (std::size_t i = 0; !renderer && i < in.Actors.size(); ++i)
  {
    renderer = vtkRelievoMaterialEye::FindRenderer(in.Actors[i]);
  }
  return renderer;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool maps = program->IsUniformUsed("relievoTextureTransform");
  const bool mirrors = in.Environment && vtkRelievoReflection::IsIn(program);
  if (!mapper || !actor || (!maps && !mirrors))
  {
    return true;
  }
  vtkRenderer* renderer = this->FindRenderer(prop);
  if (renderer)
  {
    in.Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  }
  in.Use();
  vtkRelievoMaterialEye::SetParameters(program, renderer);
  if (maps)
  {
    this->SetMapParameters(program, actor);
  }
  if (mirrors)
  {
    vtkRelievoReflection::SetParameters(program, in.Window, in.Environment,
      { this->Reflectivity, this->Roughness, this->ReflectionWeight, this->IrradianceWeight });
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetMapParameters(vtkShaderProgram* program, vtkActor* actor)
{
  Internals& in = *this->Internal;
  const float transform[4] = { static_cast<float>(this->TextureScale[0]),
    static_cast<float>(this->TextureScale[1]), static_cast<float>(this->TextureOffset[0]),
    static_cast<float>(this->TextureOffset[1]) };
  program->SetUniform4f("relievoTextureTransform", transform);
  const bool normals = this->ActivateMap(program, in.Normals, "relievoNormalMap");
  const bool heights = this->ActivateMap(program, in.Heights, "relievoHeightMap");
  const float flip = this->FlipGreen ? -1.f : 1.f;
  const float strength = normals ? static_cast<float>(this->NormalStrength) : 0.f;
  const float weight[2] = { strength, flip * strength };
  program->SetUniform2f("relievoNormalWeight", weight);
  const float decode[3][2] = { { 2.f, -1.f }, { 1.f, 0.f }, { 0.f, 1.f } };
  program->SetUniform2f(
    "relievoNormalDecode", decode[normals ? (in.Normals.IsFloat() ? 1 : 0) : 2]);
  if (program->IsUniformUsed("relievoHeightMap"))
  {
    this->SetHeightParameters(program, actor, heights);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::ActivateMap(
  vtkShaderProgram* program, vtkRelievoMaterialMap& map, const char* sampler)
{
  Internals& in = *this->Internal;
  if (!program->IsUniformUsed(sampler))
  {
    return false;
  }
  std::string remark;
  const bool there = map.Load(in.Window, this->Repeat, remark);
  if (there)
  {
    program->SetUniformi(sampler, map.Activate());
  }
  else
  {
    // As if it were flat, from a unit that others leave alone: samplers of two kinds on one unit
    // are an error.
    GLint units = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    program->SetUniformi(sampler, units - 1);
    if (!in.Window && in.Said.insert(map.GetName()).second)
    {
      vtkWarningMacro("A picture without the "
        << map.GetName() << ": the actor is in no renderer that is being drawn.");
    }
  }
  if (!remark.empty())
  {
    vtkWarningMacro("The " << map.GetName() << ": " << remark << ".");
  }
  this->TellFaults();
  return there;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::TellFaults()
{
  Internals& in = *this->Internal;
  for (vtkRelievoMaterialMap* map : { &in.Normals, &in.Heights })
  {
    const std::string fault = this->Enabled ? map->TakeFault() : std::string();
    if (!fault.empty())
    {
      vtkErrorMacro("No " << map->GetName() << ": " << fault << ".");
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetHeightParameters(vtkShaderProgram* program, vtkActor* actor, bool there)
{
  Internals& in = *this->Internal;
  if (!there)
  {
    const float flat[2] = { 0.f, 1.f };
    const float texel[2] = { 1.f, 1.f };
    program->SetUniform2f("relievoHeightDecode", flat);
    program->SetUniform2f("relievoHeightSize", texel);
    return;
  }
  double range[2] = { this->HeightRange[0], this->HeightRange[1] };
  if (range[0] == range[1])
  {
    in.Heights.GetRange(range);
  }
  const double span = range[1] != range[0] ? range[1] - range[0] : 1.0;
  const float decode[2] = { static_cast<float>(1.0 / span), static_cast<float>(-range[0] / span) };
  program->SetUniform2f("relievoHeightDecode", decode);
  const float size[2] = { static_cast<float>(in.Heights.GetWidth()),
    static_cast<float>(in.Heights.GetHeight()) };
  program->SetUniform2f("relievoHeightSize", size);
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  program->SetUniformf("relievoHeightScale", static_cast<float>(this->HeightScale * scale));
  const float steps[4] = { static_cast<float>(this->StepsPerTexel),
    static_cast<float>(this->MinimumSteps), static_cast<float>(this->MaximumSteps),
    static_cast<float>(this->Bisections) };
  program->SetUniform4f("relievoSteps", steps);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoMaterial::GetShaderStageMTime()
{
  // VTK asks before each drawing: images may be others than before.
  Internals& in = *this->Internal;
  this->UpdateStructure();
  this->TellFaults();
  vtkRelievoEnvironmentTextures::Structure structure;
  if (this->Enabled && in.Environment)
  {
    structure = vtkRelievoEnvironmentTextures::Of(in.Environment).GetStructure();
  }
  structure = structure.Projection ? structure : vtkRelievoEnvironmentTextures::Structure();
  if (!(structure == in.EnvironmentStructure))
  {
    in.EnvironmentStructure = structure;
    in.StructureTime.Modified();
  }
  return in.StructureTime.GetMTime();
}
