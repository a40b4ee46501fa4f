// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits the maps of a light: evenly spaced ones, unless a derived class fits others.
#ifndef vtkRelievoShadowFitter_h
#define vtkRelievoShadowFitter_h

#include "vtkRelievoShadowFit.h"

#include <vector>

class vtkRelievoShadowFitter
{
public:
  vtkRelievoShadowFitter() = default;
  virtual ~vtkRelievoShadowFitter() = default;
  vtkRelievoShadowFitter(const vtkRelievoShadowFitter&) = delete;
  void operator=(const vtkRelievoShadowFitter&) = delete;

  // The views of a light's maps; by default those of vtkRelievoShadowFit::Fit.
  virtual std::vector<vtkRelievoShadowView> Fit(const vtkRelievoShadowLight& light,
    const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
    const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
    const std::vector<vtkRelievoBox>& casters, const vtkRelievoShadowFit::Request& request) const
  {
    return vtkRelievoShadowFit::Fit(light, visible, scene, casters, request);
  }
};

#endif
