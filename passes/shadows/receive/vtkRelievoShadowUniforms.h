// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/receive.glsl, and of the method's own section.
#ifndef vtkRelievoShadowUniforms_h
#define vtkRelievoShadowUniforms_h

#include <set>

class vtkActor;
class vtkRelievoShadowMethod;
class vtkShaderProgram;
struct vtkRelievoShadowContext;

class vtkRelievoShadowUniforms
{
public:
  // Sets the uniforms for the program's drawing of an actor. strength: share of a blocked light
  // that is removed from the picture.
  void Set(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
    const vtkRelievoShadowMethod& method, double strength, vtkActor* actor);

  // The programs' uniforms belong to another frame, or to other maps.
  void Forget() { this->Programs.clear(); }

private:
  std::set<vtkShaderProgram*> Programs; // programs with this frame's uniforms
};

#endif
