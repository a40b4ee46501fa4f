// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowVerdicts.h
 * @brief A scene of the shadow benches in a window, and how many of its verdicts are wrong.
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
/** Share of `part` in `all`, in percent; NaN where there is none. */
double Percent(long long part, long long all);

/** One scene, light and window size, with its truth; ways to shadows come and go. */
class ShadowVerdicts
{
public:
  /** `view`: what the pixels show, of another light of the same scene and size, or null. */
  ShadowVerdicts(const std::string& name, vtkPolyData* mesh, const ShadowLight& light, int width,
    int height, const relievoTest::TruthImage* view = nullptr);

  /** Draws from now on by VTK's physically based shading. */
  void UsePBR();

  /** What a way gets wrong; plain frames are drawn again afterwards. */
  relievoTest::ShadowErrors Measure(const ShadowWay& way, int mapSize);

  /** What the renderer's pass as it is gets wrong. */
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
