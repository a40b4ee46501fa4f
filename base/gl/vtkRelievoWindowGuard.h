// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Restores a renderer's camera and viewport, and its window's size, tile and buffers, at the end of
// the scope. Until then the window draws no tile.
#ifndef vtkRelievoWindowGuard_h
#define vtkRelievoWindowGuard_h

#include "vtkCamera.h"
#include "vtkRelievoBaseGLModule.h" // for the export macro
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

class vtkRenderer;

class VTKRELIEVOBASEGL_EXPORT vtkRelievoWindowGuard
{
public:
  explicit vtkRelievoWindowGuard(vtkRenderer* renderer); // in a window
  ~vtkRelievoWindowGuard();
  vtkRelievoWindowGuard(const vtkRelievoWindowGuard&) = delete;
  void operator=(const vtkRelievoWindowGuard&) = delete;

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkCamera> Camera; // null: the renderer had none
  double Viewport[4];
  int Size[2];
  bool OffScreenBuffers;
  int TileScale[2];
  double TileViewport[4];
};

#endif
