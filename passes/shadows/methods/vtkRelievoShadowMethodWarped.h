// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gives more of a sun's map to the region near the camera: the map lies in the ground, with the
// rays sheared upright, and its density changes along the view direction in linear pieces. Lamps
// have even maps.
#ifndef vtkRelievoShadowMethodWarped_h
#define vtkRelievoShadowMethodWarped_h

#include "vtkRelievoShadowMethod.h"

class vtkRelievoShadowMethodWarped : public vtkRelievoShadowMethod
{
public:
  std::vector<vtkRelievoShadowView> Fit(const vtkRelievoShadowLight& light,
    const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
    const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
    const std::vector<vtkRelievoBox>& casters,
    const vtkRelievoShadowFit::Request& request) const override;
  std::string GetShader() const override { return "shadow/warped.glsl"; }

  // The width of a texel depends on the place: the shader subtracts the bias.
  double GetBias(const vtkRelievoShadowView&, double) const override { return 0.0; }

  void SetFrameUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work) const override;
  vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const override;
};

#endif
