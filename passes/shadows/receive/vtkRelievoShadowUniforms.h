// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/receive.glsl, which all methods have in common.
#ifndef vtkRelievoShadowUniforms_h
#define vtkRelievoShadowUniforms_h

class vtkActor;
class vtkRelievoShadowMethod;
class vtkShaderProgram;
struct vtkRelievoShadowContext;

namespace vtkRelievoShadowUniforms
{
// Sets the uniforms that have one value for all that a program draws in a frame. strength: share of
// a blocked light that is removed from the picture.
void SetFrame(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
  const vtkRelievoShadowMethod& method, double strength);

void SetActor(vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor);
}

#endif
