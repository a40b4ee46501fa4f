// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws all samples of a picture's opaque surfaces at once, into a raster finer than the pixels
// (vtkRelievoSampleLattice), so that meshes are transformed once instead of once per sample. The
// mean of each pixel's samples, in linear light, replaces the delegate's drawing.
//
// A few samples of each pixel are drawn first; then all samples of the pixels with an edge
// (vtkRelievoSampleMarks): the raster's depth hides everything elsewhere.
//
// Pictures with a large raster are drawn in parts, one after the other.
#ifndef vtkRelievoSampleRaster_h
#define vtkRelievoSampleRaster_h

#include "vtkRelievoAccess.h"
#include "vtkRelievoMarkedTriangles.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoSampleMarks.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoColorTarget;
class vtkRelievoFrameContext;
class vtkTextureObject;
class vtkWindow;

class vtkRelievoSampleRaster : public vtkRelievoResource
{
public:
  vtkRelievoSampleRaster();

  // The reason why the frame's samples have to be drawn one by one; "" if there is none.
  static std::string FindObstacle(const vtkRelievoFrameContext& context);

  ///@{
  // Redirects the delegate's drawing to the raster. End() draws the other parts, and writes the
  // means into the target's colour and depth.
  void Begin(vtkRelievoFrameContext& context, const vtkRelievoColorTarget& target);
  void End(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target);
  ///@}

  // The reason why the raster could not be made; "" if it was. Samples are then drawn one by one.
  const std::string& GetFault() const { return this->Fault; }
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  using Part = std::array<int, 4>; // x, y, width, height in pixels of the viewport

  // The raster of a part.
  struct Grid
  {
    const vtkRelievoSampleLattice* Lattice = nullptr;
    std::vector<float> Cells; // two numbers each
    int First[2] = { 0, 0 };
    vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
    vtkSmartPointer<vtkTextureObject> Color;
    vtkSmartPointer<vtkTextureObject> Depth;

    std::string Make(vtkRelievoFrameContext& context, const vtkRelievoSampleLattice& lattice,
      const std::vector<Part>& parts, Grid* spare); // error message, or empty
    glm::ivec2 GetRoom() const;
    glm::dmat4 GetToRaster(const vtkRelievoFrameContext& context, const Part& part) const;
    void Bind(vtkRelievoFrameContext& context, const Part& part);
    void Free(vtkWindow* window);
  };

  static std::vector<Part> Divide(const vtkRelievoSampleLattice& lattice, const Part& part,
    const std::function<bool(const glm::ivec2&)>& fits);
  void Begin(vtkRelievoFrameContext& context, Grid& grid, const Part& part, bool marked);
  void End(
    vtkRelievoFrameContext& context, vtkRelievoColorTarget& target, const Part& part, bool marked);
  static bool HasFew(const vtkRelievoFrameContext& context);
  std::string Describe(const vtkRelievoFrameContext& context) const;
  void DrawMarked(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target);
  void Leave(vtkRelievoFrameContext& context);
  void Free(vtkWindow* window);
  void DrawActors(const vtkRelievoFrameContext& context, std::size_t part, bool translucent);
  void DrawTranslucent(vtkRelievoFrameContext& context, std::size_t part);

  Part Drawn{};            // of the viewport
  std::vector<Part> Parts; // of Drawn, each a raster of few samples
  std::string Fault;
  vtkRelievoSampleLattice FewOfEach;
  Grid Few;
  Grid All;
  Grid* Drawing = nullptr; // Few or All
  vtkRelievoSampleMarks Marks;
  std::vector<std::unique_ptr<vtkRelievoMarkedTriangles>> Triangles; // of the props; empty: all
  std::optional<vtkRelievoAccess::Camera::Projection> Projection;
  vtkRelievoScreenQuad Mean;
  vtkRelievoScreenQuad MeanOfMarked;
  vtkRelievoScreenQuad Nearest;
};

#endif
