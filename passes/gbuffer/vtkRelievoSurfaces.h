// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What surfaces do with light, as VTK's properties have it: what of it is stored per pixel, and
// which of VTK's shaders can leave their lights to a later stage.
#ifndef vtkRelievoSurfaces_h
#define vtkRelievoSurfaces_h

#include <map>
#include <string>

class vtkActor;
class vtkMapper;
class vtkOpenGLPolyDataMapper;
class vtkRenderWindow;
class vtkRenderer;
struct vtkRelievoFrameScene;
class vtkShaderProgram;

struct vtkRelievoSurfaces
{
  bool Detail = false;   // some visible surface gives back a share only, shines, or is PBR
  bool Specular = false; // some has a highlight of Phong's
  bool Pbr = false;      // some is PBR

  // Of the visible actors.
  static vtkRelievoSurfaces Find(const vtkRelievoFrameScene& scene);

  // Why VTK has to light all of it, in words: something is drawn over surfaces without taking their
  // place, or in ways that are not known. Empty if it has not.
  static std::string WhyAllLit(const vtkRelievoFrameScene& scene, vtkRenderWindow* window);

  // Whether an actor has vertex or geometry shader code of its own, which may move what is seen.
  static bool AreMoved(const vtkRelievoFrameScene& scene);
  static bool IsMoved(vtkActor* actor);

  // Takes VTK's lights out of its fragment shader. False where they are not found as VTK writes
  // them.
  static bool LeaveLightOut(std::string& fragment);

  // Why VTK has to light the actor, in words; empty if it has not.
  static std::string WhyLit(vtkActor* actor, vtkRenderer* renderer);

  // Why VTK has to light what each mapper draws, in words; mappers that it need not light are left
  // out. `mirrors`: the view does.
  static std::map<vtkMapper*, std::string> FindLit(
    const vtkRelievoFrameScene& scene, vtkRenderer* renderer, bool mirrors);

  // Why VTK has to light what the mapper draws now with this fragment shader, in words; empty if it
  // has not.
  static std::string WhyLit(vtkOpenGLPolyDataMapper* mapper, const std::string& fragment);

  // What each mapper draws for the visible actors: lines wider than 1, something else, or both.
  enum LineShaders
  {
    WideLines = 1,
    NoWideLines = 2,
    BothKinds = WideLines | NoWideLines
  };
  static std::map<vtkMapper*, int> FindLineShaders(const vtkRelievoFrameScene& scene);

  static void SetUniforms(vtkShaderProgram* program, vtkActor* actor);
};

#endif
