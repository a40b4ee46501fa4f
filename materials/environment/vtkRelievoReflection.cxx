// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoReflection.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"

using namespace vtkRelievoSpliceText;

namespace
{
const char* const Dec = "//RELIEVO::Reflection::Dec";
const char* const Look = "//RELIEVO::Reflection::Look";
const char* const Light = "//RELIEVO::Reflection::Light";
const char* const Mirror = "//RELIEVO::Reflection::Mirror";

std::string Section(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("material/environment.glsl", section);
}
}

//------------------------------------------------------------------------------
void vtkRelievoReflection::Mark(std::string& fragment)
{
  MarkBehind(fragment, "//VTK::Light::Dec", Dec);
  FillMark(
    fragment, "//VTK::Light::Impl", std::string(Look) + "\n  //VTK::Light::Impl\n  " + Light);
  // After textures, whose own place is copied by other passes.
  FillMark(
    fragment, "//VTK::DepthPeeling::Impl", std::string(Mirror) + "\n  //VTK::DepthPeeling::Impl");
}

//------------------------------------------------------------------------------
std::string vtkRelievoReflection::Fill(std::string& vertex, std::string& geometry,
  std::string& fragment, const vtkRelievoEnvironmentTextures::Structure& structure)
{
  for (const char* mark : { Dec, Look, Light, Mirror })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark +
        "; use VTK's templates, with their tags";
    }
  }
  if (!EnsurePosition(vertex, geometry, fragment))
  {
    return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's templates";
  }
  if (!Has(fragment, "vec3 normalVCVSOutput ="))
  {
    return std::string(); // unlit: there are no normals for a reflection
  }
  auto defined = structure;
  // Recognizes PBR in all versions of VTK.
  const bool encodes = Has(fragment, ", vec3(1.0/2.2))");
  defined.Encoded = defined.Encoded || encodes;
  std::string declarations = defined.GetDefines();
  declarations += encodes ? "#define RELIEVO_PBR\n" : "";
  declarations += Has(fragment, "mat3 envMatrix;") ? "#define RELIEVO_HAS_ENV_MATRIX\n" : "";
  FillMark(fragment, Dec, declarations + Section("FragmentDec"));
  FillMark(fragment, Look, Section("Look"));
  FillMark(fragment, Light, Section("Light"));
  FillMark(fragment, Mirror, Section("Mirror"));
  return std::string();
}

//------------------------------------------------------------------------------
bool vtkRelievoReflection::IsIn(vtkShaderProgram* program)
{
  return program->IsUniformUsed("relievoReflection");
}

//------------------------------------------------------------------------------
void vtkRelievoReflection::SetParameters(vtkShaderProgram* program, vtkOpenGLRenderWindow* window,
  vtkRelievoEnvironment* environment, const Values& values)
{
  vtkRelievoEnvironmentTextures& textures = vtkRelievoEnvironmentTextures::Of(environment);
  const bool active = textures.Activate(window, program, values.Roughness);
  const double intensity = environment->GetIntensity();
  const float reflection[4] = { static_cast<float>(values.Reflectivity),
    static_cast<float>(values.Roughness),
    active ? static_cast<float>(values.ReflectionWeight) : 0.f, static_cast<float>(intensity) };
  program->SetUniform4f("relievoReflection", reflection);
  vtkNew<vtkMatrix3x3> rotation;
  environment->GetWorldToEnvironment(rotation);
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(rotation->GetElement(i % 3, i / 3));
  }
  program->SetUniformMatrix3x3("relievoEnvironmentFromWorld", columns);
  if (program->IsUniformUsed("relievoIrradiance"))
  {
    const double factor = intensity * values.IrradianceWeight / vtkMath::Pi();
    float coefficients[9][3];
    for (int i = 0; i < 9; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        coefficients[i][c] =
          static_cast<float>(factor * environment->GetIrradiance()->GetComponent(i, c));
      }
    }
    program->SetUniform3fv("relievoIrradiance", 9, coefficients);
  }
}
