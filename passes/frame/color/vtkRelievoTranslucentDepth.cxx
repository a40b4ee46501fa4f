// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTranslucentDepth.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
// VTK's translucent actors write no depth unless this is forced.
void DrawWithDepth(vtkProp* prop, vtkRenderer* renderer)
{
  if (!prop->GetPropertyKeys())
  {
    prop->SetPropertyKeys(vtkNew<vtkInformation>());
  }
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkOpenGLActor::GLDepthMaskOverride();
  const bool had = keys->Has(key) != 0;
  const int before = had ? keys->Get(key) : 0;
  keys->Set(key, 1);
  prop->RenderTranslucentPolygonalGeometry(renderer);
  if (had)
  {
    keys->Set(key, before);
  }
  else
  {
    keys->Remove(key);
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoTranslucentDepth::vtkRelievoTranslucentDepth() = default;

//------------------------------------------------------------------------------
vtkRelievoTranslucentDepth::~vtkRelievoTranslucentDepth()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentDepth::Allocate(vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  if (this->Window == context.Window && this->Depth && this->Size[0] == v[2] &&
    this->Size[1] == v[3])
  {
    return true;
  }
  this->Release(this->Window);
  this->Window = context.Window;
  this->Size[0] = v[2];
  this->Size[1] = v[3];
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(context.Window);
  this->Depth->AllocateDepth(
    static_cast<unsigned int>(v[2]), static_cast<unsigned int>(v[3]), vtkTextureObject::Float32);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(context.Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddDepthAttachment(this->Depth);
  context.Window->GetState()->vtkglDrawBuffer(GL_NONE);
  context.Window->GetState()->vtkglReadBuffer(GL_NONE);
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentDepth::Draw(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  if (!this->Allocate(context))
  {
    this->Release(context.Window);
    return false;
  }
  this->Range[0] = static_cast<float>(context.View.Near);
  this->Range[1] = static_cast<float>(context.View.Far);
  this->Range[2] = context.View.Parallel ? 1.0f : 0.0f;
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  const float far = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &far);
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    if (props[i]->HasTranslucentPolygonalGeometry())
    {
      DrawWithDepth(props[i], context.Renderer);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoTranslucentDepth::GetBytes() const
{
  return this->Depth ? static_cast<vtkIdType>(4) * this->Size[0] * this->Size[1] : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentDepth::Release(vtkWindow* window)
{
  if (this->Depth && window)
  {
    this->Depth->ReleaseGraphicsResources(window);
  }
  if (this->Framebuffer && window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  this->Depth = nullptr;
  this->Framebuffer = nullptr;
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
std::string vtkRelievoTranslucentDepth::GetDefines() const
{
  return "#define RELIEVO_TRANSLUCENT_DEPTH\n";
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentDepth::Activate(vtkShaderProgram* program)
{
  this->Depth->Activate();
  program->SetUniformi("relievoTranslucentZ", this->Depth->GetTextureUnit());
  program->SetUniform3f("relievoTranslucentRange", this->Range);
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentDepth::Deactivate()
{
  this->Depth->Deactivate();
}
