// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethod.h"

#include "vtkRelievoShadowMethodExact.h"
#include "vtkRelievoShadowMethodForward.h"
#include "vtkRelievoShadowMethodMap.h"
#include "vtkRelievoShadowMethodWarped.h"
#include "vtkRelievoShadowStage.h"

//------------------------------------------------------------------------------
std::unique_ptr<vtkRelievoShadowMethod> vtkRelievoShadowMethod::Make(int method)
{
  switch (method)
  {
    case vtkRelievoShadowStage::METHOD_FORWARD:
      return std::make_unique<vtkRelievoShadowMethodForward>();
    case vtkRelievoShadowStage::METHOD_WARPED:
      return std::make_unique<vtkRelievoShadowMethodWarped>();
    case vtkRelievoShadowStage::METHOD_EXACT:
      return std::make_unique<vtkRelievoShadowMethodExact>();
    default:
      return std::make_unique<vtkRelievoShadowMethodMap>();
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowView> vtkRelievoShadowMethod::Fit(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
  const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
  const std::vector<vtkRelievoBox>& casters, const vtkRelievoShadowFit::Request& request) const
{
  return vtkRelievoShadowFit::Fit(light, visible, scene, casters, request);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowErrorLaw::GetShare(int mapSize) const
{
  return std::min(1.0, this->At2048 * std::pow(mapSize / 2048.0, -this->Power));
}
