// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The verdicts of rays about visible surfaces, computed once per pixel before the picture is drawn,
// and cached while view, surfaces, casters and lights stay. Small triangles fill few of a fragment
// shader's lanes; pixels fill all of them.
//
// Only for plain surfaces (vtkRelievoCasterDraw), once VTK has drawn them, and for glyphs: a
// fragment without an entry, or with an entry for another place, traces the ray itself, with the
// same verdict.
#ifndef vtkRelievoVisibilityPrepass_h
#define vtkRelievoVisibilityPrepass_h

#include "vtkRelievoBoxTree.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoSeenGlyphs.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoCasterDraw;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoVisibilityPrepass
{
public:
  static constexpr vtkIdType BytesPerPixel = 16; // visible surface, its depth, verdicts
  static constexpr vtkIdType BytesOfBefore = 8;  // in addition, once surfaces have moved
  static constexpr vtkIdType BytesOfColors = 12; // in addition
  static constexpr int Tile = 8;                 // pixels: as in shaders/shadow/tilesFS.glsl

  enum Kind // kind of verdicts
  {
    Whole,  // all or nothing
    Shares, // of a light
    Colors  // shares of its red, green and blue, and of the total
  };

  vtkRelievoVisibilityPrepass();
  ~vtkRelievoVisibilityPrepass();
  vtkRelievoVisibilityPrepass(const vtkRelievoVisibilityPrepass&) = delete;
  void operator=(const vtkRelievoVisibilityPrepass&) = delete;

  // Reserves texture units for the frame. False if none is free.
  bool TakeUnits(vtkOpenGLRenderWindow* window);

  // Begins a frame, without any data yet, and reserves texture units. False if none is free.
  bool Begin(vtkOpenGLRenderWindow* window, const vtkRelievoFrameCamera& view, Kind kind);

  // Number of lights whose verdicts can be stored; 0: none.
  int GetMostLights() const;

  // The visible glyphs of a frame. False without memory for all or a texture unit, or if nothing
  // fits.
  bool SetGlyphs(const std::vector<vtkRelievoPlacedMesh>& glyphs);

  // Draws the visible surfaces of these actors and the glyphs, unless they are known from the
  // previous frame. Returns draw calls.
  int DrawSurfaces(const std::vector<vtkActor*>& actors, vtkRelievoCasterDraw& draw);

  // The casters for rays.
  struct Past
  {
    double Version = 0.0;
    // Boxes, in the tree's coordinates, around all differences from the previous version, or null.
    const std::vector<vtkRelievoBoxTree::Box>* Moved = nullptr;
  };

  // Traces the rays, unless the verdicts are known from the previous frame. rays: values that
  // identify the input; tell: sets the uniforms of shaders/rays/walk.glsl. Returns draw calls.
  int DrawVerdicts(const std::vector<glm::vec4>& sources, const std::vector<double>& rays,
    const Past& past, const std::function<void(vtkShaderProgram*)>& tell);

  // Uniforms for looking up the verdicts; before they are drawn, there are none.
  void SetUniforms(vtkShaderProgram* program) const;
  void SetActorUniforms(vtkShaderProgram* program, vtkActor* actor) const;

  void Unbind();
  vtkIdType GetBytes() const;
  static vtkIdType GetBytes(int width, int height);
  void Forget()
  {
    this->SurfacesDrawn.clear();
    this->VerdictsDrawn.clear();
  }
  void Release(vtkWindow* window);

private:
  enum Texture
  {
    Surfaces,
    Before, // Surfaces at the time of the verdicts
    Verdicts,
    Depth,
    Tiles,
    Count
  };
  static int CountTiles(int pixels) { return (pixels + Tile - 1) / Tile; }
  bool Allocate();
  bool KeepSurfaces();
  std::string GetSource(const std::string& name) const;
  bool IsReady();
  void Bind(int first, int second);
  void BeginDrawing(unsigned int target, int width, int height);
  bool KeepsVerdicts(const std::vector<double>& lights, const Past& past) const;
  int FindVerdicts(const std::vector<glm::vec4>& sources, int lights,
    const std::vector<vtkRelievoBoxTree::Box>* moved,
    const std::function<void(vtkShaderProgram*)>& tell);
  void EndDrawing();
  void Tell(vtkShaderProgram* program, int lights) const;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  const vtkWindow* Owner = nullptr; // also valid in its destructor; for comparison only
  vtkRelievoFrameCamera View;
  double Levels = 2.0;           // of a verdict
  bool Colored = false;          // verdicts with colours
  bool AllocatedColored = false; // whether the present texture has colours
  int Lights = 0;                // with verdicts
  bool Room = false;             // whether OpenGL has the memory
  bool Fits = false;             // room, and an invertible projection
  bool Broken = false;           // the shaders do not compile, or cannot draw
  bool Checked = false;
  unsigned int Textures[Count] = {};
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkRelievoSeenGlyphs Glyphs;
  std::unique_ptr<vtkRelievoScopedState> SavedState; // while drawing
  std::vector<double> SurfacesDrawn;                 // state of the present data; empty: none
  std::vector<double> VerdictsDrawn;
  std::vector<double> LightsOfVerdicts;
  double VersionOfVerdicts = 0.0;
  std::vector<double> RaysOfVerdicts;
  bool SurfacesAreNew = false; // changed since the verdicts
  bool HasBefore = false;      // with the same camera
  bool RoomForBefore = false;
  unsigned int DepthFormat = 0;
  int Width = 0;
  int Height = 0;
  int Units[2] = { -1, -1 };
  unsigned int Arrays = 0;
};

#endif
