// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LampWindows.h
 * @brief Reference scenes with lamps around them, and with as many lights of VTK's.
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
 * The radius of so many lamps, anywhere in a box around the scene, of which `reaching` reach a
 * point in the middle of the box, on average.
 */
double RadiusFor(int lamps, double reaching);

/** Lamps in the box, with colours; the same for the same number. */
vtkSmartPointer<vtkPolyData> MakeLamps(int count);

/** One way of drawing the scene with the lamps. */
struct LitWindow
{
  LitWindow(vtkPolyData* mesh, int pixels, vtkPolyData* lamps, double radius, int way);

  /** A frame in which every lamp has moved. */
  relievoTest::Timed Frame();

  /** Lamps computed and reaching, on average over the pixels. */
  void Count(double& computed, double& reaching);

  std::unique_ptr<SceneWindow> Window;
  vtkNew<vtkRelievoLamps> Lamps;
  vtkRelievoLampsStage* Stage = nullptr;
};

/** Lights of VTK's at the lamps' places, one for each. */
std::unique_ptr<SceneWindow> MakePeer(vtkPolyData* mesh, int pixels, vtkPolyData* lamps);
}

#endif
