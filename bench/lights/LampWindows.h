// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LampWindows.h
 * @brief Reference scenes surrounded by lamps, and by as many VTK lights.
 */
#ifndef relievoBenchLampWindows_h
#define relievoBenchLampWindows_h

#include "FrameBench.h"

#include <vtkNew.h>
#include <vtkRelievoLamps.h>
#include <vtkRelievoLampsStage.h>
#include <vtkSmartPointer.h>

#include <memory>

class vtkPolyData;

namespace relievoBench
{
/**
 * The radius for so many lamps, at random in a box around the scene, of which `reaching` reach a
 * point in the middle of the box, on average.
 */
double RadiusFor(int lamps, double reaching);

/** Lamps in the box, with colours; deterministic for each number. */
vtkSmartPointer<vtkPolyData> MakeLamps(int count);

/** One method of drawing the scene with the lamps. */
struct LitWindow
{
  LitWindow(vtkPolyData* mesh, int pixels, vtkPolyData* lamps, double radius, int way);

  /** Draws a frame in which every lamp has moved. */
  relievoTest::Timed Frame();

  /** The numbers of lamps computed and reaching, averaged over the pixels. */
  void Count(double& computed, double& reaching);

  std::unique_ptr<SceneWindow> Window;
  vtkNew<vtkRelievoLamps> Lamps;
  vtkRelievoLampsStage* Stage = nullptr;
};

/** A scene with a VTK light in place of each lamp. */
std::unique_ptr<SceneWindow> MakePeer(vtkPolyData* mesh, int pixels, vtkPolyData* lamps);
}

#endif
