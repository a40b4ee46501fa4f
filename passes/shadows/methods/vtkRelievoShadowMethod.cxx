// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethod.h"

#include "vtkRelievoShadowMethodExact.h"
#include "vtkRelievoShadowMethodForward.h"
#include "vtkRelievoShadowMethodMap.h"
#include "vtkRelievoShadowMethodWarped.h"
#include "vtkRelievoShadowMethods.h"

//------------------------------------------------------------------------------
std::unique_ptr<vtkRelievoShadowMethod> vtkRelievoShadowMethod::Make(int method)
{
  switch (method)
  {
    case vtkRelievoShadowMethods::FORWARD:
      return std::make_unique<vtkRelievoShadowMethodForward>();
    case vtkRelievoShadowMethods::WARPED:
      return std::make_unique<vtkRelievoShadowMethodWarped>();
    case vtkRelievoShadowMethods::EXACT:
      return std::make_unique<vtkRelievoShadowMethodExact>();
    default:
      return std::make_unique<vtkRelievoShadowMethodMap>();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowErrorLaw::GetShare(int mapSize) const
{
  return std::min(1.0, this->At2048 * std::pow(mapSize / 2048.0, -this->Power));
}
