// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowSplice.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"

#include <sstream>

using namespace vtkRelievoSpliceText;

namespace
{
const char* const Dec = "//RELIEVO::Shadow::Dec";
const char* const Impl = "//RELIEVO::Shadow::Impl";
const char* const UniformFlow = "//RELIEVO::Shadow::UniformFlow";

std::string Section(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("shadow/receive.glsl", section);
}

std::string Numbered(const char* section, int number, int slot)
{
  std::string text = Section(section);
  FillWord(text, "RELIEVO_NUMBER", std::to_string(number));
  FillWord(text, "RELIEVO_SLOT", std::to_string(slot));
  return text;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowSplice::Mark(
  std::string& vertex, std::string& geometry, std::string& fragment)
{
  MarkVaryings(vertex, geometry, fragment);
  MarkBehind(fragment, "//VTK::Light::Dec", Dec);
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Light::Impl", std::string(Impl) + "\n  //VTK::Light::Impl", false);
  vtkShaderProgram::Substitute(fragment, "//VTK::UniformFlow::Impl",
    std::string(UniformFlow) + "\n  //VTK::UniformFlow::Impl", false);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowSplice::Fill(std::string& vertex, std::string& geometry,
  std::string& fragment, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
  const Structure& structure)
{
  std::ostringstream dec;
  std::string lights;
  std::string impl;
  for (std::size_t slot = 0; slot < structure.ShaderIndices.size(); ++slot)
  {
    const int number = structure.ShaderIndices[slot];
    if (Has(fragment, "uniform vec3 lightColor" + std::to_string(number) + ";"))
    {
      lights += Numbered("LightDec", number, static_cast<int>(slot));
      impl += Numbered("LightImpl", number, static_cast<int>(slot));
    }
  }
  if (structure.ShaderIndices.empty() || (impl.empty() && !structure.Unlit))
  {
    return std::string();
  }
  for (const char* mark : { Dec, Impl, UniformFlow })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark;
    }
  }
  if (!EnsurePosition(vertex, geometry, fragment))
  {
    return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl";
  }
  const bool impostor = Has(fragment, "vertexVC.xyz =") && Has(fragment, "normalVCVSOutput");
  const bool surface = DrawsTriangles(mapper) && !impostor &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  dec << "#define RELIEVO_SHADOW_LIGHTS " << structure.ShaderIndices.size() << "\n";
  dec << "#define RELIEVO_SHADOW_FACES " << structure.Faces << "\n";
  dec << "#define RELIEVO_SHADOW_NUMBERS " << structure.Numbers << "\n";
  if (impostor)
  {
    dec << "#define RELIEVO_SHADOW_IMPOSTOR\n";
  }
  if (surface)
  {
    dec << "#define RELIEVO_SHADOW_FACE_NORMAL\n";
  }
  std::string visibility = Section("FragmentImpl");
  FillWord(visibility, "RELIEVO_IMPOSTOR_NORMAL", impostor ? "normalVCVSOutput" : "vec3(0.0)");
  FillMark(fragment, Dec, dec.str() + Section("FragmentDec") + lights);
  FillMark(fragment, UniformFlow, Section("UniformFlow"));
  FillMark(fragment, Impl, visibility + impl);
  return std::string();
}
