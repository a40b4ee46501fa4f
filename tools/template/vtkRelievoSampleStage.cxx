// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleStage.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoView.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkRelievoSampleStage);

//------------------------------------------------------------------------------
vtkRelievoSampleStage::vtkRelievoSampleStage()
  : Quad(new vtkRelievoScreenQuad)
{
}

//------------------------------------------------------------------------------
vtkRelievoSampleStage::~vtkRelievoSampleStage() = default;

//------------------------------------------------------------------------------
bool vtkRelievoSampleStage::IsNeeded(const vtkRenderState*, std::string& reason)
{
  reason = this->Strength > 0.0 ? "fades what is far" : "Strength is 0";
  return this->Strength > 0.0;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoSampleStage::GetNeededLayers()
{
  return { "depth" };
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoGBufferPass* gbuffer = frame->GetGBuffer();
  this->DrawCalls = 0;
  if (!gbuffer->GetTexture(0))
  {
    return; // the frame drew nothing that has a depth
  }
  vtkShaderProgram* program = this->Quad->Ready(window, gbuffer, "sample/sampleFS.glsl");
  if (!program)
  {
    vtkErrorMacro("The shader sample/sampleFS.glsl does not compile: see the errors above.");
    return;
  }
  const float color[3] = { static_cast<float>(this->Color[0]), static_cast<float>(this->Color[1]),
    static_cast<float>(this->Color[2]) };
  program->SetUniform3f("sampleColor", color);
  program->SetUniformf("sampleStrength", static_cast<float>(this->Strength));

  vtkRelievoView view;
  view.Take(renderer, s);
  vtkOpenGLState* state = window->GetState();
  state->Push();
  state->vtkglEnable(GL_BLEND);
  // The picture's alpha says what is drawn there: fading does not change it.
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  this->Quad->Draw(window, gbuffer, view);
  state->Pop();
  this->DrawCalls = 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
}
