// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeferredScenes.h
 * @brief A scene that is drawn with and without deferred shading.
 */
#ifndef relievoTestDeferredScenes_h
#define relievoTestDeferredScenes_h

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRelievoDeferredStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace relievoTest
{
/** A sphere, a cone, a floor with texture coordinates, and a wall, in colours; no light yet. */
struct DeferredScene
{
  DeferredScene(int width, int height);

  /** A sun from (3, 5, 2). */
  vtkLight* AddLight();

  /** Colours the actor's points by their height, through a colour map. */
  void ColorByHeight(int actor);

  /** A checker of two colours. */
  void SetTexture(int actor);

  /**
   * Renders without and with deferred shading, which then stays on. Returns the largest difference
   * of a channel, in levels of 255. Writes both pictures of `what` if it is above 2.
   */
  int CompareWithVTK(const std::string& what);

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  vtkRelievoPass* Frame;
  vtkRelievoDeferredStage* Stage;
};
}

#endif
