// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The camera of a frame in double: transforms a pixel and its depth to a point, in both
// projections, off-centre frusta included.
#ifndef vtkRelievoFrameCamera_h
#define vtkRelievoFrameCamera_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoMatrix.h"

#include <glm/mat4x4.hpp>

class vtkRenderState;
class vtkRenderer;

struct VTKRELIEVOFRAME_EXPORT vtkRelievoFrameCamera
{
  int Viewport[4] = { 0, 0, 0, 0 }; // x, y, width, height in the bound framebuffer
  bool Parallel = false;
  double Near = 0.0;
  double Far = 1.0;
  glm::dmat4 WorldToView = glm::dmat4(1.0); // column-major, the layout of GLM
  glm::dmat4 ViewToNDC = glm::dmat4(1.0);

  ///@{
  // In float, for shaders.
  glm::mat4 GetProjection() const;
  glm::mat4 GetViewToWorld() const;
  ///@}

  // Negative if the picture is mirrored.
  double GetWinding() const;

  void Take(vtkRenderer* renderer, const vtkRenderState* s);
};

#endif
