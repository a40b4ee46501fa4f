// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferTextures.h"

#include "vtkRelievoDrawTable.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferTarget.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

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
void vtkRelievoGBufferTextures::SetDraws(
  const vtkRelievoDrawTable& draws, vtkOpenGLRenderWindow* window)
{
  this->Draws = &draws;
  this->Window = window;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::Release(vtkWindow* window)
{
  this->Draws = nullptr;
  this->Parts.Release(window);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::ActivateParts(vtkShaderProgram* program)
{
  if (this->Draws)
  {
    // Splits 32-bit numbers into halves, which floats represent exactly.
    std::vector<float> texels;
    for (const vtkRelievoDrawTable::PartStart& start : this->Draws->GetParts())
    {
      texels.insert(texels.end(),
        { static_cast<float>(start.First >> 16), static_cast<float>(start.First & 0xffffu),
          static_cast<float>(start.Part), 0.0f });
    }
    this->Draws = nullptr;
    this->NumberOfParts = static_cast<int>(texels.size() / 4);
    texels.resize(std::max<std::size_t>(texels.size(), 4));
    if (!this->Parts.Upload(this->Window, texels, 4).empty())
    {
      // Too many for a list: all parts count as one. Without a texture OpenGL reports an error.
      this->NumberOfParts = 1;
      this->Parts.Upload(this->Window, std::vector<float>(4), 4);
    }
  }
  this->Parts.Activate(program, "relievoParts");
  program->SetUniformi("relievoNumberOfParts", this->NumberOfParts);
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
  if (program->IsUniformUsed("relievoNumberOfParts"))
  {
    this->ActivateParts(program);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTextures::Deactivate()
{
  for (int i = 0; i < this->Layout->GetNumberOfAttachments(); ++i)
  {
    this->Target->GetTexture(i)->Deactivate();
  }
  if (this->Parts.GetTextureUnit() >= 0)
  {
    this->Parts.Deactivate();
  }
}
