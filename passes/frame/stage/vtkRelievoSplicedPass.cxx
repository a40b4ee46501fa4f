// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSplicedPass.h"

#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"

//------------------------------------------------------------------------------
vtkRelievoSplicedPass::vtkRelievoSplicedPass() = default;

//------------------------------------------------------------------------------
vtkRelievoSplicedPass::~vtkRelievoSplicedPass() = default;

//------------------------------------------------------------------------------
bool vtkRelievoSplicedPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->IsSplicing() && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->MarkShaders({ vertexShader, geometryShader, fragmentShader });
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoSplicedPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (this->IsSplicing() && mapper && actor)
  {
    this->SpliceShaders({ vertexShader, geometryShader, fragmentShader }, mapper, actor);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoSplicedPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
vtkRelievoTrialSplice::Outcome vtkRelievoSplicedPass::TrySplice(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLRenderWindow* window, vtkActor* actor,
  const std::function<std::string()>& fill)
{
  return vtkRelievoTrialSplice::Try(shaders, window, actor->GetShaderProperty(), fill);
}

//------------------------------------------------------------------------------
bool vtkRelievoSplicedPass::IsNews(vtkObject* mapper, const vtkRelievoTrialSplice::Outcome& outcome)
{
  return !outcome.Error.empty() && this->Reported.IsNew(outcome.GetKey(mapper));
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoSplicedPass::GetShaderStageMTime()
{
  // Keys copied meanwhile call the pass outside its own drawing: it splices nothing there.
  if (!this->IsSplicing() || this->BuiltUnspliced)
  {
    this->ModifyShaders();
    this->BuiltUnspliced = !this->IsSplicing();
  }
  return this->ShaderTime.GetMTime();
}
