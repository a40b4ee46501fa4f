// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAmbientCatch.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"

using namespace vtkRelievoSpliceText;

vtkStandardNewMacro(vtkRelievoAmbientCatch);

namespace
{
const char* const Defines = "//RELIEVO::Ambient::Defines";
const char* const Dec = "//RELIEVO::Ambient::Dec";
const char* const Impl = BehindLight[3];

std::string Section(const char* section)
{
  std::string text = vtkRelievoShaderLibrary::GetSection("ambient/catch.glsl", section);
  FillWord(text, "relievo", "ambient");
  FillWord(text, "RELIEVO_", "AMBIENT_");
  FillWord(text, "AMBIENT_SPARED", "RELIEVO_DIRECT_LIGHT");
  return text;
}
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientCatch::Begin(vtkOpenGLRenderWindow* window,
  const std::vector<vtkProp*>& props, const std::function<void(vtkShaderProgram*)>& tell)
{
  this->Window = window;
  this->Tell = tell;
  for (vtkProp* prop : props)
  {
    this->Keys.Add(prop, this);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientCatch::End()
{
  this->Keys.Remove(this);
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientCatch::MarkShaders(const vtkRelievoShaderTexts& shaders)
{
  MarkVaryings(shaders.Vertex, shaders.Geometry, shaders.Fragment);
  MarkBehind(shaders.Fragment, "//VTK::System::Dec", Defines);
  MarkBehind(shaders.Fragment, "//VTK::Light::Dec", Dec);
  MarkBehindLight(shaders.Fragment, Impl);
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientCatch::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  std::string& fragment = shaders.Fragment;
  const auto fill = [&]() -> std::string {
    if (!Has(fragment, "normalVCVSOutput") || !Has(fragment, Dec) || !Has(fragment, Impl) ||
      !EnsurePosition(shaders.Vertex, shaders.Geometry, fragment))
    {
      return "it is not lit, or its shaders are not of VTK's templates";
    }
    FillMark(fragment, Defines, GetContract());
    FillMark(fragment, Dec, Section("Dec"));
    FillMark(fragment, Impl, Section("Impl"));
    return {};
  };
  const vtkRelievoTrialSplice::Outcome outcome = TrySplice(shaders, this->Window, actor, fill);
  if (this->IsNews(mapper, outcome))
  {
    vtkErrorMacro("No ambient occlusion on the shadow catcher: " << outcome.Error << ".");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoAmbientCatch::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (this->Window && program->IsUniformUsed("ambientToLocal"))
  {
    this->Tell(program);
  }
  return true;
}
