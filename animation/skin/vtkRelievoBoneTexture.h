// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bones on the graphics card, as shaders/skin/skin.glsl reads them.
 */
#ifndef vtkRelievoBoneTexture_h
#define vtkRelievoBoneTexture_h

#include "vtkRelievoTextureBuffer.h"

#include <glm/mat4x4.hpp>

#include <string>
#include <vector>

namespace relievo
{
class BoneTexture
{
public:
  void SetMatrices(const std::vector<glm::dmat4>& matrices);
  void SetMotions(const std::vector<glm::dmat4>& matrices); ///< for dual quaternions
  std::size_t GetNumberOfTexels() const { return this->Values.size() / 4; }

  /// Uploads the matrices or motions to the window. Returns "", or why it cannot hold them.
  std::string Upload(vtkOpenGLRenderWindow* window);

  void Activate() { this->Buffer.Activate(); }
  void Deactivate() { this->Buffer.Deactivate(); }
  void SetUniform(vtkShaderProgram* program); ///< while it is active

  void Release(vtkWindow* window) { this->Buffer.Release(window); }

private:
  std::vector<float> Values;
  bool Changed = true;
  vtkRelievoTextureBuffer Buffer;
};
}

#endif
