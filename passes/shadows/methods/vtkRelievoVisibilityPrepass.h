// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The verdicts of rays about what is seen, found once for each pixel before the picture is drawn,
// and kept while view, surfaces, casters and lights stay as they are. Small triangles fill few of
// the lanes that a fragment shader runs in; pixels fill all of them.
//
// It holds for plain surfaces alone (vtkRelievoCasterDraw), once VTK has drawn them: whoever is not
// found in it, or finds another place there, goes the way of the ray itself, to the same verdict.
#ifndef vtkRelievoVisibilityPrepass_h
#define vtkRelievoVisibilityPrepass_h

#include "vtkRelievoBoxTree.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoScopedState.h"
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
  static constexpr vtkIdType BytesPerPixel = 16; // what is seen, its depth, verdicts
  static constexpr vtkIdType BytesOfBefore = 8;  // beside, once surfaces have moved
  static constexpr vtkIdType BytesOfColors = 12; // beside
  static constexpr int Tile = 8;                 // pixels: as in shaders/shadow/tilesFS.glsl

  enum Kind // what verdicts are
  {
    Whole,  // all or nothing
    Shares, // of a light
    Colors  // shares of its red, green and blue, and of the whole
  };

  vtkRelievoVisibilityPrepass();
  ~vtkRelievoVisibilityPrepass();
  vtkRelievoVisibilityPrepass(const vtkRelievoVisibilityPrepass&) = delete;
  void operator=(const vtkRelievoVisibilityPrepass&) = delete;

  // Takes texture units for the frame. False if there are none left.
  bool TakeUnits(vtkOpenGLRenderWindow* window);

  // Begins a frame, of which nothing is known yet, and takes texture units for it. False if there
  // are none left.
  bool Begin(vtkOpenGLRenderWindow* window, const vtkRelievoFrameCamera& view, Kind kind);

  // How many lights' verdicts can be found in it; 0: of none.
  int GetMostLights() const;

  // What is seen of these actors, if it is not known from the frame before. Returns draw calls.
  int DrawSurfaces(const std::vector<vtkActor*>& actors, vtkRelievoCasterDraw& draw);

  // What rays go past.
  struct Past
  {
    double Version = 0.0;
    // Boxes in the tree's coordinates that hold all that differs from the version before, or null.
    const std::vector<vtkRelievoBoxTree::Box>* Moved = nullptr;
  };

  // What rays find about it, if they have not found it in the frame before. rays: numbers that tell
  // them from others; tell: uniforms of shaders/rays/walk.glsl. Returns draw calls.
  int DrawVerdicts(const std::vector<glm::vec4>& sources, const std::vector<double>& rays,
    const Past& past, const std::function<void(vtkShaderProgram*)>& tell);

  // What has been found, for those who look it up; before the verdicts are drawn, nothing.
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
    Before, // what Surfaces were when the verdicts were found
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
  const vtkWindow* Owner = nullptr; // the same, known also in its destructor; for comparison only
  vtkRelievoFrameCamera View;
  double Levels = 2.0;           // of a verdict
  bool Colored = false;          // verdicts of colours
  bool AllocatedColored = false; // the same of the texture that there is
  int Lights = 0;                // whose verdicts are there
  bool Room = false;             // OpenGL has the memory
  bool Fits = false;             // there is room, and a way from a pixel and its depth to a place
  bool Broken = false;           // the shaders do not compile, or cannot draw
  bool Checked = false;
  unsigned int Textures[Count] = {};
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkRelievoScopedState> Kept; // while drawing
  std::vector<double> SurfacesDrawn;           // the state of what is there; none if nothing is
  std::vector<double> VerdictsDrawn;
  std::vector<double> LightsOfVerdicts;
  double VersionOfVerdicts = 0.0;
  std::vector<double> RaysOfVerdicts;
  bool SurfacesAreNew = false; // since the verdicts were found
  bool HasBefore = false;      // from the same camera
  bool RoomForBefore = false;
  unsigned int DepthFormat = 0;
  int Width = 0;
  int Height = 0;
  int Units[2] = { -1, -1 };
  unsigned int Arrays = 0;
};

#endif
