// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws all samples of a picture's opaque surfaces at once, into a raster that is finer than the
// pixels (vtkRelievoSampleLattice): meshes are not transformed once for each sample. The mean of
// each pixel's samples, in linear light, takes the place of what the delegate draws.
//
// First a few samples of each pixel are drawn; then all samples, where these say that there is an
// edge (vtkRelievoSampleMarks): elsewhere the raster's depth leaves nothing visible.
//
// Pictures whose raster is large are drawn in parts, one after the other.
#ifndef vtkRelievoSampleRaster_h
#define vtkRelievoSampleRaster_h

#include "vtkRelievoAccess.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoSampleMarks.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkSmartPointer.h"

#include <array>
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

  // Why the frame's samples have to be drawn one by one, in words; "": they need not.
  static std::string FindObstacle(const vtkRelievoFrameContext& context);

  ///@{
  // What the delegate draws between these goes into the raster; End draws the parts that the
  // delegate has not, and puts the means into the target's colour and depth.
  void Begin(vtkRelievoFrameContext& context, const vtkRelievoColorTarget& target);
  void End(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target);
  ///@}

  // Why it could not be made, in words; "": it could. Samples are then drawn one by one.
  const std::string& GetFault() const { return this->Fault; }
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  using Part = std::array<int, 4>; // x, y, width, height in pixels of the viewport

  // A raster of a part.
  struct Grid
  {
    const vtkRelievoSampleLattice* Lattice = nullptr;
    std::vector<float> Cells; // two numbers each
    int First[2] = { 0, 0 };
    vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
    vtkSmartPointer<vtkTextureObject> Color;
    vtkSmartPointer<vtkTextureObject> Depth;

    std::string Make(vtkRelievoFrameContext& context, const vtkRelievoSampleLattice& lattice,
      const glm::ivec2& pixels); // or why not, in words
    glm::dmat4 GetToRaster(const vtkRelievoFrameContext& context, const Part& part) const;
    void Bind(vtkRelievoFrameContext& context, const Part& part);
    void Free(vtkWindow* window);
  };

  static std::vector<Part> Divide(
    const vtkRelievoSampleLattice& lattice, const Part& part, glm::ivec2& pixels);
  void Begin(vtkRelievoFrameContext& context, Grid& grid, const Part& part, bool marked);
  void End(
    vtkRelievoFrameContext& context, vtkRelievoColorTarget& target, const Part& part, bool marked);
  static bool HasFew(const vtkRelievoFrameContext& context);
  std::string Describe(const vtkRelievoFrameContext& context) const;
  void DrawMarked(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target);
  void Leave(vtkRelievoFrameContext& context);
  void Free(vtkWindow* window);
  static void DrawOpaque(vtkRelievoFrameContext& context);
  static void DrawTranslucent(vtkRelievoFrameContext& context);

  Part Drawn{};            // of the viewport
  std::vector<Part> Parts; // of it, each in a raster of few samples
  std::string Fault;
  vtkRelievoSampleLattice FewOfEach;
  Grid Few;
  Grid All;
  Grid* Drawing = nullptr; // one of these
  vtkRelievoSampleMarks Marks;
  std::optional<vtkRelievoAccess::Camera::Projection> Projection;
  vtkRelievoScreenQuad Mean;
  vtkRelievoScreenQuad MeanOfMarked;
  vtkRelievoScreenQuad Nearest;
};

#endif
