// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The OpenGL state that a frame restores. VTK's own record of it may name deleted buffers: those
// are not bound again.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h> // for OpenGL
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <functional>

namespace testScopedState
{
namespace
{
using relievoTest::Picture;
using relievoTest::Stage;

struct Case
{
  const char* Name;
  void (*Set)(vtkRelievoPass*);
};

const Case Cases[] = {
  { "layers in the picture's pass", [](vtkRelievoPass* frame) { frame->RequestLayer("cell"); } },
  { "layers in a pass of their own",
    [](vtkRelievoPass* frame) {
      frame->RequestLayer("cell");
      frame->GetLayersStage()->ShareGeometryPassOff();
    } },
  { "a layer shown",
    [](vtkRelievoPass* frame) {
      frame->SetDisplayLayer("normal");
      frame->GetLayersStage()->ShareGeometryPassOff();
    } },
  { "shadow maps", [](vtkRelievoPass* frame) { frame->ShadowsOn(); } },
  { "forward shadows",
    [](vtkRelievoPass* frame) {
      frame->ShadowsOn();
      frame->GetShadowStage()->SetMethod(vtkRelievoShadowStage::METHOD_FORWARD);
    } },
};

// An application that draws with OpenGL itself (Qt's widget is one) tells VTK to look at the state
// anew; the buffer that was bound then is deleted later.
void LeaveBuffersBehind(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLuint array = 0;
  GLuint buffers[2] = { 0, 0 };
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  static_cast<vtkOpenGLRenderWindow*>(window)->GetState()->Reset();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
  glDeleteBuffers(2, buffers);
  glDeleteVertexArrays(1, &array);
}

// VTK's record, and the real state.
struct Record
{
  GLint Viewport[4];
  GLint Scissor[4];
  GLint BlendSource = 0;
  GLint DepthFunction = 0;
  GLint Draw = 0;
  GLint Read = 0;
  unsigned char Flags[5];
  unsigned char Colors[4];

  void Take(vtkOpenGLState* state, bool believed)
  {
    const auto integers = [&](GLenum name, GLint* to) {
      believed ? state->vtkglGetIntegerv(name, to) : glGetIntegerv(name, to);
    };
    const auto booleans = [&](GLenum name, unsigned char* to) {
      believed ? state->vtkglGetBooleanv(name, to) : glGetBooleanv(name, to);
    };
    integers(GL_VIEWPORT, this->Viewport);
    integers(GL_SCISSOR_BOX, this->Scissor);
    integers(GL_BLEND_SRC_RGB, &this->BlendSource);
    integers(GL_DEPTH_FUNC, &this->DepthFunction);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &this->Read);
    booleans(GL_BLEND, &this->Flags[0]);
    booleans(GL_CULL_FACE, &this->Flags[1]);
    booleans(GL_DEPTH_TEST, &this->Flags[2]);
    booleans(GL_SCISSOR_TEST, &this->Flags[3]);
    booleans(GL_DEPTH_WRITEMASK, &this->Flags[4]);
    booleans(GL_COLOR_WRITEMASK, this->Colors);
  }
  bool operator==(const Record& other) const
  {
    return std::equal(this->Viewport, this->Viewport + 4, other.Viewport) &&
      std::equal(this->Scissor, this->Scissor + 4, other.Scissor) &&
      this->BlendSource == other.BlendSource && this->DepthFunction == other.DepthFunction &&
      this->Draw == other.Draw && this->Read == other.Read &&
      std::equal(this->Flags, this->Flags + 5, other.Flags) &&
      std::equal(this->Colors, this->Colors + 4, other.Colors);
  }
};

void Test(const Case& c)
{
  const std::string what = c.Name;
  const Stage stage(160, 120);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(0.8));
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeBox(3., 0.1, 3.));
  vtkNew<vtkLight> sun;
  sun->SetPosition(3., 5., 2.);
  sun->PositionalOff();
  stage.Renderer->AddLight(sun);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(stage.Window.GetPointer());
  Picture(stage.Window);
  Record plain;
  plain.Take(window->GetState(), false);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  c.Set(frame);
  const auto expected = Picture(stage.Window);
  Record with;
  with.Take(window->GetState(), false);
  RELIEVO_CHECK_THAT(with == plain, what + ": OpenGL's state is as without");
  Record believed;
  believed.Take(window->GetState(), true);
  RELIEVO_CHECK_THAT(believed == with, what + ": OpenGL's state is as VTK believes");
  const relievoTest::GLCheck gl(stage.Window);
  for (int i = 0; i < 2; ++i)
  {
    LeaveBuffersBehind(stage.Window);
    sun->SetPosition(3., 5. + i, 2.); // maps are drawn anew
    Picture(stage.Window);
  }
  RELIEVO_CHECK_AT_MOST(gl.Errors(), 0, what + ": OpenGL errors");
  sun->SetPosition(3., 5., 2.);
  relievoTest::SamePicture(expected, Picture(stage.Window), what);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testScopedState)
{
  relievoTest::Session session;
  for (const Case& c : Cases)
  {
    Test(c);
  }
  return session.Result();
}
}
