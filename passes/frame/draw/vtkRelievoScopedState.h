// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Saves the OpenGL state that passes change, and restores it at the end of the scope.
// vtkOpenGLState::Push and Pop restore the buffers that VTK believes to be bound at Push, with an
// OpenGL error if they have been deleted.
#ifndef vtkRelievoScopedState_h
#define vtkRelievoScopedState_h

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLState.h"

class vtkRelievoScopedState
{
public:
  explicit vtkRelievoScopedState(vtkOpenGLState* state)
    : Bindings(state)
    , Viewport(state)
    , Scissor(state)
    , BlendFunction(state)
    , DepthFunction(state)
    , DepthMask(state)
    , ColorMask(state)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
  }
  vtkRelievoScopedState(const vtkRelievoScopedState&) = delete;
  void operator=(const vtkRelievoScopedState&) = delete;

private:
  class FramebufferBindings
  {
  public:
    explicit FramebufferBindings(vtkOpenGLState* state)
      : State(state)
    {
      this->State->PushFramebufferBindings();
    }
    ~FramebufferBindings() { this->State->PopFramebufferBindings(); }
    FramebufferBindings(const FramebufferBindings&) = delete;
    void operator=(const FramebufferBindings&) = delete;

  private:
    vtkOpenGLState* State;
  };

  FramebufferBindings Bindings;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

#endif
