// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lighting properties of surfaces in VTK: the values to store per pixel, and the shaders of VTK
// that can leave their lights to a later stage.
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
  // Some visible surface has a diffuse coefficient below 1, highlights, or is PBR.
  bool Detail = false;
  bool Specular = false; // some surface has Phong highlights
  bool Pbr = false;      // some surface is PBR

  // Evaluates the visible actors.
  static vtkRelievoSurfaces Find(const vtkRelievoFrameScene& scene);

  // The reason why VTK has to light all surfaces: something is drawn over surfaces without
  // replacing them, or in unknown ways. Empty if there is none.
  static std::string WhyAllLit(const vtkRelievoFrameScene& scene, vtkRenderWindow* window);

  // Whether an actor has its own vertex or geometry shader code, which may move vertices.
  static bool AreMoved(const vtkRelievoFrameScene& scene);
  static bool IsMoved(vtkActor* actor);

  // Removes VTK's lights from its fragment shader. False if VTK's code is not found.
  static bool LeaveLightOut(std::string& fragment);

  // The reason why VTK has to light the actor; empty if there is none.
  static std::string WhyLit(vtkActor* actor, vtkRenderer* renderer);

  // The reasons why VTK has to light a mapper's surfaces, for each mapper that needs it. `mirrors`:
  // the view is mirrored.
  static std::map<vtkMapper*, std::string> FindLit(
    const vtkRelievoFrameScene& scene, vtkRenderer* renderer, bool mirrors);

  // The reason why VTK has to light the mapper's present draw with this fragment shader; empty if
  // there is none.
  static std::string WhyLit(vtkOpenGLPolyDataMapper* mapper, const std::string& fragment);

  // Kinds of primitives that mappers draw for the visible actors: lines wider than 1, or these and
  // others. Mappers without such lines are left out.
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
