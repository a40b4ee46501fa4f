// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowVerdicts.h
 * @brief A scene of the shadow benches in a window, and its number of errors.
 */
#ifndef relievoBenchShadowVerdicts_h
#define relievoBenchShadowVerdicts_h

#include "CodedScenes.h"
#include "EmbreeScene.h"
#include "ShadowErrors.h"
#include "ShadowWays.h"

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace relievoBench
{
/** Share of `part` in `all`, in percent; NaN if `all` is 0. */
double Percent(long long part, long long all);

/** One scene, light and window size, with its truth, to measure several shadow methods. */
class ShadowVerdicts
{
public:
  /** `view`: the pixels of another light of the same scene and size, or null. */
  ShadowVerdicts(const std::string& name, vtkPolyData* mesh, const ShadowLight& light, int width,
    int height, const relievoTest::TruthImage* view = nullptr);

  /** Draws by VTK's physically based shading from now on. */
  void UsePBR();

  /** Measures the errors of a method; plain frames are drawn again afterwards. */
  relievoTest::ShadowErrors Measure(const ShadowWay& way, int mapSize);

  /** Measures the errors of the renderer's current pass. */
  relievoTest::ShadowErrors MeasureAsItIs();

  relievoTest::ReferenceScene Scene;
  vtkSmartPointer<vtkRenderWindow> Window;
  relievoTest::TruthImage View;
  relievoTest::ShadowTruth Truth;

private:
  vtkSmartPointer<vtkImageData> Plain;
  double Gamma = 1.;
};
}

#endif
