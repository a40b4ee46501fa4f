// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFillSplice.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"

#include <cctype>

using namespace vtkRelievoSpliceText;

vtkStandardNewMacro(vtkRelievoFillSplice);

namespace
{
const char* const FillDec = "//RELIEVO::Fill::Dec";
const char* const FillImpl = BehindLight[1];
constexpr const char* FillFile = "fill/fill.glsl";

// Leaves a light out of VTK's code: its colour is black wherever main() reads it.
void LeaveOut(std::string& fragment, int light)
{
  const std::string name = "lightColor" + std::to_string(light);
  std::string black = vtkRelievoShaderLibrary::GetSection(FillFile, "Black");
  black.erase(black.find_last_not_of('\n') + 1);
  std::size_t at = fragment.find(name, fragment.find("void main()"));
  while (at != std::string::npos)
  {
    const std::size_t end = at + name.size();
    const bool whole = !std::isdigit(static_cast<unsigned char>(fragment[end]));
    if (whole)
    {
      fragment.replace(at, name.size(), black);
    }
    at = fragment.find(name, at + (whole ? black.size() : name.size()));
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoFillSplice::Begin(vtkOpenGLRenderWindow* window, const std::vector<vtkProp*>& props,
  const Structure& structure, const std::function<void(vtkShaderProgram*)>& tell)
{
  if (!(structure == this->Is))
  {
    this->Is = structure;
    this->ModifyShaders();
  }
  this->Window = window;
  this->Tell = tell;
  for (vtkProp* prop : props)
  {
    this->Keys.Add(prop, this);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFillSplice::End()
{
  this->Keys.Remove(this);
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoFillSplice::MarkShaders(const vtkRelievoShaderTexts& shaders)
{
  MarkVaryings(shaders.Vertex, shaders.Geometry, shaders.Fragment);
  MarkBehind(shaders.Fragment, "//VTK::Light::Dec", FillDec);
  MarkBehindLight(shaders.Fragment, FillImpl);
}

//------------------------------------------------------------------------------
// VTK's lights stay where there is no such light to take their place: on PBR surfaces, whose
// lighting is another, and on unlit ones.
void vtkRelievoFillSplice::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  std::string& fragment = shaders.Fragment;
  if (!Has(fragment, "normalVCVSOutput") || !Has(fragment, "diffuseColor") ||
    Has(fragment, "vec3 albedo =") || !Has(fragment, FillDec) || !Has(fragment, FillImpl))
  {
    return;
  }
  const auto fill = [&]() -> std::string {
    if (!EnsurePosition(shaders.Vertex, shaders.Geometry, fragment))
    {
      return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's "
             "templates";
    }
    for (const int light : this->Is.Lights)
    {
      LeaveOut(fragment, light);
    }
    const std::string defines = this->Is.Sky ? "#define RELIEVO_FILL_SKY\n" : "";
    FillMark(fragment, FillDec, defines + vtkRelievoShaderLibrary::GetSection(FillFile, "Dec"));
    FillMark(fragment, FillImpl, vtkRelievoShaderLibrary::GetSection(FillFile, "Impl"));
    return {};
  };
  const vtkRelievoTrialSplice::Outcome outcome = TrySplice(shaders, this->Window, actor, fill);
  if (this->IsNews(mapper, outcome))
  {
    vtkErrorMacro("Fill lights are drawn one by one on " << mapper->GetClassName() << ": "
                                                         << outcome.Error << ".");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoFillSplice::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (this->Window && program->IsUniformUsed("relievoFillLight"))
  {
    this->Tell(program);
  }
  return true;
}
