// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeSplice.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoTrialSplice.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoVolumeSplice);

//------------------------------------------------------------------------------
vtkRelievoVolumeSplice::vtkRelievoVolumeSplice() = default;

//------------------------------------------------------------------------------
vtkRelievoVolumeSplice::~vtkRelievoVolumeSplice() = default;

//------------------------------------------------------------------------------
void vtkRelievoVolumeSplice::Begin(
  const std::vector<vtkProp*>& props, vtkOpenGLRenderWindow* window)
{
  this->Window = window;
  for (vtkProp* prop : props)
  {
    this->Keys.Add(prop, this);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeSplice::End()
{
  this->Keys.Remove(this);
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeSplice::GetNames(const std::string& fragment)
{
  using namespace vtkRelievoSpliceText;
  std::string names;
  names += Has(fragment, "in_eyePosObjs[") ? "#define RELIEVO_VOLUME_HAS_EYES\n" : "";
  names +=
    Has(fragment, "#define TOTAL_NUMBER_LIGHTS") ? "#define RELIEVO_VOLUME_HAS_LIGHT_COUNTS\n" : "";
  names += Has(fragment, "in_lightPositional[") ? "#define RELIEVO_VOLUME_HAS_LIGHT_KINDS\n" : "";
  return names + vtkRelievoShaderLibrary::GetSection("volumes/names.glsl", "Dec");
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeSplice::HasPartitions(vtkVolumeMapper* mapper)
{
  auto* gpu = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return gpu &&
    std::any_of(gpu->AssembledInputs.begin(), gpu->AssembledInputs.end(), [](const auto& input) {
      const auto& parts = input.second.Texture->GetPartitions();
      return parts[0] * parts[1] * parts[2] > 1;
    });
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeSplice::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragment, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Window && vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    this->Mark(fragment);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeSplice::PostReplaceShaderValues(std::string& vertex, std::string& geometry,
  std::string& fragment, vtkAbstractMapper* abstractMapper, vtkProp* prop)
{
  auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(abstractMapper);
  auto* volume = vtkVolume::SafeDownCast(prop);
  if (this->Window && mapper && volume)
  {
    const vtkRelievoTrialSplice::Outcome outcome =
      vtkRelievoTrialSplice::Try({ vertex, geometry, fragment }, this->Window,
        volume->GetShaderProperty(), [&]() { return this->Fill(fragment, mapper, volume); });
    if (!outcome.Error.empty() && this->Reported.IsNew(outcome.GetKey(mapper)) && this->Report)
    {
      this->Report(
        std::string("a ") + mapper->GetClassName() + " draws without it: " + outcome.Error);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeSplice::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(abstractMapper);
  auto* volume = vtkVolume::SafeDownCast(prop);
  if (this->Window && this->Set && mapper && volume)
  {
    this->Set(program, mapper, volume);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoVolumeSplice::GetShaderStageMTime()
{
  // Keys copied meanwhile call the splice outside of Begin and End.
  if (!this->Window)
  {
    this->ModifyShaders();
  }
  return this->ShaderTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeSplice::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}
