// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoneTexture.h"

#include "vtkRelievoSkinBones.h"

#include "vtkShaderProgram.h"

namespace relievo
{
//------------------------------------------------------------------------------
void BoneTexture::SetMatrices(const std::vector<glm::dmat4>& matrices)
{
  this->Values.clear();
  this->Changed = true;
  for (const glm::dmat4& m : matrices)
  {
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        this->Values.push_back(static_cast<float>(m[column][row]));
      }
    }
  }
}

//------------------------------------------------------------------------------
void BoneTexture::SetMotions(const std::vector<glm::dmat4>& matrices)
{
  this->Values.clear();
  this->Changed = true;
  for (const glm::dmat4& m : matrices)
  {
    const BoneMotion<float> motion = GetMotion<float>(m);
    for (int column = 0; column < 3; ++column)
    {
      const glm::vec3& c = motion.Stretch[column];
      this->Values.insert(this->Values.end(), { c.x, c.y, c.z, 0.f });
    }
    for (const glm::vec4& q : { motion.Rotation, motion.Dual })
    {
      this->Values.insert(this->Values.end(), { q.x, q.y, q.z, q.w });
    }
  }
}

//------------------------------------------------------------------------------
std::string BoneTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Changed && this->Buffer.IsIn(window))
  {
    return "";
  }
  const std::string error = this->Buffer.Upload(window, this->Values, 4);
  this->Changed = !error.empty();
  return error.empty() ? "" : "the bones do not fit (" + error + "): use vtkRelievoSkin";
}

//------------------------------------------------------------------------------
void BoneTexture::SetUniform(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("relievoBones"))
  {
    this->Buffer.SetUniform(program, "relievoBones");
  }
}
}
