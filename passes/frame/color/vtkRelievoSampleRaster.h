// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws all samples of a picture's opaque surfaces at once, into a raster that is finer than the
// pixels (vtkRelievoSampleLattice): meshes are transformed once, not once for each sample. The mean
// of each pixel's samples, in linear light, takes the place of what the delegate draws.
//
// Pictures whose raster is large are drawn in parts, one after the other.
#ifndef vtkRelievoSampleRaster_h
#define vtkRelievoSampleRaster_h

#include "vtkRelievoAccess.h"
#include "vtkRelievoResource.h"
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

  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  using Part = std::array<int, 4>; // x, y, width, height in pixels of the viewport

  void FindParts(const vtkRelievoFrameContext& context, const int drawn[4]);
  void BeginPart(vtkRelievoFrameContext& context, const Part& part);
  void Leave(vtkRelievoFrameContext& context);
  void Free(vtkWindow* window);
  static void DrawTranslucent(vtkRelievoFrameContext& context);
  void EndPart(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target, const Part& part);

  std::vector<Part> Parts;
  int Size[2] = { 0, 0 };   // of the raster that holds each of them
  std::vector<float> Cells; // two numbers each
  int First[2] = { 0, 0 };
  int Right[2] = { 1, 0 };
  int Up[2] = { 0, 1 };
  std::string Fault;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  std::optional<vtkRelievoAccess::Camera::Projection> Projection;
  vtkRelievoScreenQuad Mean;
  vtkRelievoScreenQuad Nearest;
};

#endif
