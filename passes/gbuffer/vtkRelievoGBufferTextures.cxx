// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferTextures.h"

#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferTarget.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::Set(const vtkRelievoGBufferLayout& layout,
  vtkRelievoGBufferTarget& target, const int offset[2], bool worldNormals)
{
  this->Layout = &layout;
  this->Target = &target;
  std::copy_n(offset, 2, this->Offset);
  this->WorldNormals = worldNormals;
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferTextures::GetDefines() const
{
  return this->Layout->GetDefines();
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::Activate(vtkShaderProgram* program)
{
  for (int i = 0; i < this->Layout->GetNumberOfAttachments(); ++i)
  {
    vtkTextureObject* texture = this->Target->GetTexture(i);
    texture->Activate();
    program->SetUniformi(
      ("relievoWords" + std::to_string(i + 1)).c_str(), texture->GetTextureUnit());
  }
  program->SetUniform2i("relievoOffset", this->Offset);
  program->SetUniformi("relievoWorldNormals", this->WorldNormals);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::Deactivate()
{
  for (int i = 0; i < this->Layout->GetNumberOfAttachments(); ++i)
  {
    this->Target->GetTexture(i)->Deactivate();
  }
}
