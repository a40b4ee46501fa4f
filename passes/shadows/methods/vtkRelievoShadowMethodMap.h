// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks places up in even maps.
#ifndef vtkRelievoShadowMethodMap_h
#define vtkRelievoShadowMethodMap_h

#include "vtkRelievoShadowMethod.h"

class vtkRelievoShadowMethodMap : public vtkRelievoShadowMethod
{
public:
  std::string GetShader() const override { return "shadow/map.glsl"; }
  vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const override;
};

#endif
