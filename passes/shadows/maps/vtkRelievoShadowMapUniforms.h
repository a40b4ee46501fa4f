// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/lookup.glsl: where places lie in the maps of lights.
#ifndef vtkRelievoShadowMapUniforms_h
#define vtkRelievoShadowMapUniforms_h

#include "vtkRelievoShadowCache.h"

#include <vector>

class vtkShaderProgram;
struct vtkRelievoShadowContext;

class vtkRelievoShadowMapUniforms
{
public:
  // Room for so many maps; shaders have places relative to `center`, in eye space.
  vtkRelievoShadowMapUniforms(
    const vtkRelievoShadowContext& work, int faces, const glm::vec3& center);

  // bias: depth of the map that is taken off receivers.
  void Set(int face, const vtkRelievoShadowCache::Map& map, double bias);

  // Sets all uniforms but those of what receives.
  void Tell(vtkShaderProgram* program) const;

private:
  const vtkRelievoShadowContext& Work;
  glm::dmat4 ViewToWorld;
  glm::dmat4 NDCToMap;
  glm::dmat4 FromCenter{ 1.0 };
  std::vector<glm::mat4> Matrices;
  std::vector<glm::vec4> Eyes;
  std::vector<float> Texels;
  std::vector<float> Layers;
  std::vector<float> Lowest;
};

#endif
