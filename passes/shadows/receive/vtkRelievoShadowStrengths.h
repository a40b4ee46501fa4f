// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `shadow maps`, for stages that compute light themselves: the share removed from each
// of the renderer's lights where it is blocked. In shaders it is
// relievoShadowStrengths[RELIEVO_SHADOW_NUMBERS].
#ifndef vtkRelievoShadowStrengths_h
#define vtkRelievoShadowStrengths_h

#include "vtkRelievoResource.h"

#include <vector>

struct vtkRelievoShadowContext;

class vtkRelievoShadowStrengths : public vtkRelievoResource
{
public:
  // `strength`: the share for a light whose own shadow attenuation is 1.
  void Set(const vtkRelievoShadowContext& work, double strength);

  // The sources, until the frame is done.
  const vtkRelievoShadowContext* GetWork() const { return this->Work; }

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override {}

private:
  std::vector<float> Strengths;
  const vtkRelievoShadowContext* Work = nullptr;
};

#endif
