// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The uniforms of shaders/shadow/receive.glsl, and of the method's section in it.
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
  // Sets the uniforms for what the program draws of an actor. strength: share of a blocked light
  // that is removed from the picture.
  void Set(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
    const vtkRelievoShadowMethod& method, double strength, vtkActor* actor);

  // What programs have is another frame's, or of other maps.
  void Forget() { this->Programs.clear(); }

private:
  std::set<vtkShaderProgram*> Programs; // those that have this frame's
};

#endif
