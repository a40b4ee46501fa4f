// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/receive.glsl, shared by all methods.
#ifndef vtkRelievoShadowUniforms_h
#define vtkRelievoShadowUniforms_h

class vtkActor;
class vtkRelievoShadowMethod;
class vtkShaderProgram;
struct vtkRelievoShadowContext;

namespace vtkRelievoShadowUniforms
{
// Sets the uniforms that are constant for a program in a frame. strength: share of a blocked light
// that is removed from the picture.
void SetFrame(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
  const vtkRelievoShadowMethod& method, double strength);

void SetActor(vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor);
}

#endif
