// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The state of a renderer and its window that drawing for a sensor changes, restored afterwards.
// Lights that follow the camera stay in place for the sensor's pose: six views must be lit alike.
// Texts, bars and the window's other renderers are hidden.
#ifndef vtkRelievoScopedRenderer_h
#define vtkRelievoScopedRenderer_h

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRelievoWindowGuard.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <vector>

class vtkProp;
class vtkRelievoCameraModel;
class vtkRenderer;

class vtkRelievoScopedRenderer
{
public:
  // Until it ends the renderer, which fills its window, has a camera of its own with this pose.
  vtkRelievoScopedRenderer(vtkRenderer* renderer, vtkRelievoCameraModel* sensor);
  ~vtkRelievoScopedRenderer();
  vtkRelievoScopedRenderer(const vtkRelievoScopedRenderer&) = delete;
  void operator=(const vtkRelievoScopedRenderer&) = delete;

private:
  struct Follower
  {
    vtkSmartPointer<vtkLight> Light;
    int Type;
    double Position[3];
    double FocalPoint[3];
    vtkSmartPointer<vtkMatrix4x4> Matrix;
  };

  void FreezeLights();
  void HideOthers();

  vtkRenderer* Renderer;
  vtkRelievoWindowGuard Guard;
  bool Attached, Gradient, Textured;
  vtkNew<vtkCamera> View;
  vtkSmartPointer<vtkTexture> Behind;
  std::vector<Follower> Followers;
  std::vector<vtkProp*> Overlays;
  std::vector<vtkRenderer*> Others;
};

#endif
