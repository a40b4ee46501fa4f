// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthSplice.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoDepthSplice);

namespace
{
constexpr const char* SlopeOfDepth = "FragDepth), dFdy("; // VTK's own expression

bool MayWriteDepth(const vtkRelievoPropParts::Part& part)
{
  vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
  if (!actor)
  {
    return false;
  }
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  // By name: cvista lacks both classes.
  return property->GetRenderPointsAsSpheres() || property->GetRenderLinesAsTubes() ||
    actor->GetShaderProperty()->GetNumberOfShaderReplacements() > 0 ||
    (mapper && (mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper")));
}
}

//------------------------------------------------------------------------------
void vtkRelievoDepthSplice::Begin(const vtkRelievoFrameScene& scene, vtkOpenGLRenderWindow* window)
{
  this->Window = window;
  for (const vtkRelievoFrameProp& drawn : scene.Props)
  {
    if (std::any_of(drawn.Parts.begin(), drawn.Parts.end(), MayWriteDepth))
    {
      this->Keys.Add(drawn.Prop, this);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDepthSplice::End()
{
  this->Keys.Remove(this);
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthSplice::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper*, vtkActor* actor)
{
  using namespace vtkRelievoSpliceText;
  std::string& fragment = shaders.Fragment;
  if (!Has(fragment, SlopeOfDepth))
  {
    return;
  }
  // Inserts a statement before the reading line, whatever else that line contains.
  TrySplice(shaders, this->Window, actor, [&fragment]() {
    const std::size_t read = fragment.find(SlopeOfDepth);
    const std::size_t line = fragment.rfind('\n', read);
    fragment.insert(line == std::string::npos ? 0 : line + 1,
      vtkRelievoShaderLibrary::GetSection("splice/depth.glsl", "UniformFlow"));
    return std::string();
  });
}
