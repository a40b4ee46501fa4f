// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What surfaces do with light, as VTK's properties have it: what of it is stored per pixel, and
// which of VTK's shaders can leave their lights to a later stage.
#ifndef vtkRelievoSurfaces_h
#define vtkRelievoSurfaces_h

#include <string>

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;

struct vtkRelievoSurfaces
{
  bool Detail = false;   // some visible surface gives back a share only, shines, or is PBR
  bool Specular = false; // some has a highlight of Phong's

  // Of the visible actors.
  static vtkRelievoSurfaces Find(const vtkRenderState* s);

  // Lets a uniform switch VTK's lights off in its fragment shader. Changes nothing where they are
  // not found as VTK writes them.
  static void MakeLightsOptional(std::string& fragment);

  // Why VTK has to light what it draws for the actor with this fragment shader, in words; empty if
  // it has not.
  static std::string WhyLit(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, vtkRenderer* renderer,
    const std::string& fragment);

  static void SetUniforms(vtkShaderProgram* program, vtkActor* actor, bool defers);
};

#endif
