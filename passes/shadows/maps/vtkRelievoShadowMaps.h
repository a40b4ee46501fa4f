// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of a frame's lights on the GPU: layers of one array of depth textures, so that any
// number of lights uses one texture unit.
#ifndef vtkRelievoShadowMaps_h
#define vtkRelievoShadowMaps_h

#include "vtkNew.h"
#include "vtkRelievoDepthRaster.h"
#include "vtkRelievoNearestDepths.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoShadowFit.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkCamera;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

class vtkRelievoShadowMaps
{
public:
  vtkRelievoShadowMaps();
  ~vtkRelievoShadowMaps();
  vtkRelievoShadowMaps(const vtkRelievoShadowMaps&) = delete;
  void operator=(const vtkRelievoShadowMaps&) = delete;

  // Allocates maps of size x size texels. True if their former contents are lost. The window's
  // context must be current.
  bool Allocate(vtkOpenGLRenderWindow* window, int size, int layers);

  // Whether OpenGL has the memory requested last.
  bool IsThere() const { return this->Texture != 0; }

  // A texture with this number of layers, without filtering; 0 if OpenGL has no memory for it.
  static unsigned int MakeArray(unsigned int format, int width, int height, int layers);

  // The largest map of this OpenGL.
  static int GetLargestSize();

  // The number of maps whose uniforms fit a shader of this OpenGL.
  static int GetMostFaces();

  // The number of rays of three numbers that fit beside half as many maps.
  static int GetMostRays();

  // NDC to map space: texels from the centre of the lowest left one, depth in [0, 1].
  static glm::dmat4 GetNDCToMap(int size);

  // The way of parallel rays with this direction through a map: texels per depth.
  glm::dvec2 GetRay(const vtkRelievoShadowView& view, const glm::dvec3& direction) const;

  // Draws one map: `casters` is called with the view as the renderer's camera, once for each piece
  // of an uneven map, between Begin and End, which save and restore OpenGL's state. Sets the view's
  // matrices to exactly those used for drawing.
  void Begin();
  // `inMemory`, if given, is called first, also for each piece: it draws casters by the processor
  // into a part of the map (x, y, width, height), and returns whether the map has any. `casters`
  // draws the others, or all if memory has no room for the map, and returns whether there was one.
  // Returns whether `inMemory` drew any.
  using CastersInMemory =
    std::function<bool(const vtkRelievoShadowView&, const int[4], vtkRelievoDepthRaster&)>;
  using Casters = std::function<bool(const vtkRelievoShadowView&, bool others)>;
  bool Draw(int layer, vtkRelievoShadowView& view, vtkRenderer* renderer,
    const CastersInMemory& inMemory, const Casters& casters);
  void End();

  // Reads the depths of the last map, row by row, and replaces them.
  void Read(std::vector<float>& depths);
  void Write(int layer, const std::vector<float>& depths);

  // For the next draw call: a sheet blocks light from both sides.
  static void DrawBothSides(vtkOpenGLRenderWindow* window);

  // Binds the maps for lookup, or an empty texture while they are being drawn. Returns false if no
  // texture unit is free.
  bool Bind(bool maps);
  void Unbind();
  int GetTextureUnit() const { return this->Unit; }

  vtkRelievoNearestDepths& GetNearest() { return this->Nearest; }
  const vtkRelievoNearestDepths& GetNearest() const { return this->Nearest; }

  int GetSize() const { return this->Size; }
  vtkIdType GetBytes() const
  {
    return (this->Texture ? GetBytes(this->Size, this->Layers) : 0) + this->Nearest.GetBytes();
  }
  static vtkIdType GetBytes(int size, int maps);
  void Release(vtkWindow* window);

private:
  bool DrawPiece(const vtkRelievoShadowView& view, const int region[4], vtkRenderer* renderer,
    bool others, const Casters& casters);
  void BindTexture(unsigned int texture);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkRelievoScopedState> SavedState; // between Begin and End
  vtkRelievoDepthRaster Raster;                      // between Begin and End
  vtkRelievoNearestDepths Nearest;
  vtkSmartPointer<vtkCamera> Camera;
  unsigned int Texture = 0;
  unsigned int Empty = 0;
  int Size = 0;
  int Layers = 0;
  int Unit = -1;
};

#endif
