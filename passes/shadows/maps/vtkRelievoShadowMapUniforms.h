// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/lookup.glsl: transforms from places to the maps of lights.
#ifndef vtkRelievoShadowMapUniforms_h
#define vtkRelievoShadowMapUniforms_h

#include "vtkRelievoShadowCache.h"

#include <vector>

class vtkShaderProgram;
struct vtkRelievoShadowContext;

class vtkRelievoShadowMapUniforms
{
public:
  // Sets the number of maps; shaders have places relative to `center`, in eye space.
  vtkRelievoShadowMapUniforms(
    const vtkRelievoShadowContext& work, int faces, const glm::vec3& center);

  // For places in other coordinates, from which `placeToView` leads to eye space.
  vtkRelievoShadowMapUniforms(
    const vtkRelievoShadowContext& work, int faces, const glm::dmat4& placeToView);

  // bias: map depth subtracted from receivers.
  void Set(int face, const vtkRelievoShadowCache::Map& map, double bias);

  // Sets all uniforms except the receivers'.
  void Tell(vtkShaderProgram* program) const;

private:
  const vtkRelievoShadowContext& Work;
  glm::dmat4 ViewToWorld;
  glm::dmat4 NDCToMap;
  glm::dmat4 PlaceToView;
  std::vector<glm::mat4> Matrices;
  std::vector<glm::vec4> Eyes;
  std::vector<float> Texels;
  std::vector<float> Layers;
  std::vector<float> Lowest;
};

#endif
