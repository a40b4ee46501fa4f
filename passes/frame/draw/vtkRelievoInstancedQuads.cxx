// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoInstancedQuads.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkShaderProgram* vtkRelievoInstancedQuads::Ready(vtkRelievoFrameContext& context,
  const std::string& vertices, const std::string& fragments, const std::string& defines)
{
  vtkOpenGLShaderCache* cache = context.Window->GetShaderCache();
  const std::string key = vertices + "\n" + fragments + "\n" + defines;
  if (this->Key != key)
  {
    std::string texts[2] = { vtkRelievoShaderLibrary::Get(vertices),
      vtkRelievoShaderLibrary::Get(fragments) };
    for (std::string& text : texts)
    {
      vtkShaderProgram::Substitute(text, "//RELIEVO::Defines", defines, false);
    }
    this->Key = key;
    this->Program = cache->ReadyShaderProgram(texts[0].c_str(), texts[1].c_str(), "");
  }
  else if (this->Program)
  {
    this->Program = cache->ReadyShaderProgram(this->Program);
  }
  this->Error =
    this->Program ? "" : "its shader " + fragments + " does not compile; see the errors before";
  if (this->Program)
  {
    const vtkRelievoFrameCamera& view = context.View;
    const float size[2] = { static_cast<float>(view.Viewport[2]),
      static_cast<float>(view.Viewport[3]) };
    glm::mat4 projection = view.GetProjection();
    this->Program->SetUniform2f("relievoSize", size);
    this->Program->SetUniformf("relievoNear", static_cast<float>(view.Near));
    this->Program->SetUniformf("relievoFar", static_cast<float>(view.Far));
    this->Program->SetUniformi("relievoParallel", view.Parallel);
    this->Program->SetUniformMatrix4x4("relievoProjection", &projection[0][0]);
  }
  return this->Program;
}

//------------------------------------------------------------------------------
void vtkRelievoInstancedQuads::Draw(int count)
{
  if (!this->Arrays)
  {
    glGenVertexArrays(1, &this->Arrays);
  }
  glBindVertexArray(this->Arrays);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkRelievoInstancedQuads::Release(vtkWindow* window)
{
  if (this->Arrays && window)
  {
    const vtkRelievoScopedContext context(window);
    glDeleteVertexArrays(1, &this->Arrays);
  }
  this->Arrays = 0;
  this->Program = nullptr;
  this->Key.clear();
}
