// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMapUniforms.h"

#include "vtkRelievoShadowContext.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
vtkRelievoShadowMapUniforms::vtkRelievoShadowMapUniforms(
  const vtkRelievoShadowContext& work, int faces, const glm::vec3& center)
  : vtkRelievoShadowMapUniforms(work, faces, glm::translate(glm::dmat4(1.0), glm::dvec3(center)))
{
}

//------------------------------------------------------------------------------
vtkRelievoShadowMapUniforms::vtkRelievoShadowMapUniforms(
  const vtkRelievoShadowContext& work, int faces, const glm::dmat4& placeToView)
  : Work(work)
  , ViewToWorld(glm::inverse(work.View.WorldToView))
  , NDCToMap(vtkRelievoShadowMaps::GetNDCToMap(work.Maps.GetSize()))
  , PlaceToView(placeToView)
  , Eyes(faces, glm::vec4(0.f))
  , Texels(faces, 0.f)
  , Layers(faces, 0.f)
  , Lowest(faces, -1.f)
{
  // Without a map, every point is outside of it.
  glm::mat4 nowhere(0.f);
  nowhere[3] = glm::vec4(-1e9f, -1e9f, 0.f, 1.f);
  this->Matrices.assign(faces, nowhere);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMapUniforms::Set(int face, const vtkRelievoShadowCache::Map& map, double bias)
{
  const vtkRelievoFrameCamera& view = this->Work.View;
  const glm::dmat4 viewToMap =
    this->NDCToMap * map.View.ViewToNDC * (map.View.WorldToView * this->ViewToWorld);
  glm::dmat4 biased = viewToMap;
  biased[3].z -= bias;
  this->Matrices[face] = glm::mat4(biased * this->PlaceToView);
  this->Eyes[face] =
    glm::vec4(viewToMap * (view.Parallel ? glm::dvec4(0, 0, 1, 0) : glm::dvec4(0, 0, 0, 1)));
  this->Texels[face] = static_cast<float>(map.View.Texel);
  this->Lowest[face] = map.View.NearCut ? 1e-7f : -1e9f;
  this->Layers[face] = static_cast<float>(map.Layer);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMapUniforms::Tell(vtkShaderProgram* program) const
{
  const int faces = static_cast<int>(this->Matrices.size());
  program->SetUniformi("relievoShadowMaps", this->Work.Maps.GetTextureUnit());
  program->SetUniformMatrix4x4v(
    "relievoShadowMatrix", faces, const_cast<float*>(&this->Matrices[0][0][0]));
  program->SetUniform4fv(
    "relievoShadowEye", faces, reinterpret_cast<const float(*)[4]>(&this->Eyes[0][0]));
  program->SetUniform1fv("relievoShadowTexel", faces, this->Texels.data());
  program->SetUniform1fv("relievoShadowLayer", faces, this->Layers.data());
  program->SetUniform1fv("relievoShadowLowest", faces, this->Lowest.data());
  program->SetUniformf("relievoShadowSize", static_cast<float>(this->Work.Maps.GetSize()));
  program->SetUniformi("relievoShadowRadius", this->Work.Radius);
}
