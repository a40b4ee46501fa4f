// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sends a ray from each pixel's own place to the light, past the casters' triangles. What casts and
// is no triangle is drawn into maps, as of the method map, and blocks what the rays let pass.
#ifndef vtkRelievoShadowMethodExact_h
#define vtkRelievoShadowMethodExact_h

#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowTree.h"

class vtkRelievoShadowMethodExact : public vtkRelievoShadowMethod
{
public:
  std::string Prepare(vtkRelievoShadowWork& work, vtkRenderer* renderer) override;
  void Unbind() override { this->Tree.Unbind(); }
  std::string GetShader() const override { return "shadow/exact.glsl"; }
  bool Traces() const override { return true; }
  void SetFrameUniforms(vtkShaderProgram* program, const vtkRelievoShadowWork& work) const override;
  vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const override;
  std::string GetReport() const override;
  vtkIdType GetBytes() const override { return this->Tree.GetBytes(); }
  void Release(vtkWindow* window) override { this->Tree.Release(window); }

private:
  vtkRelievoShadowTree Tree;
};

#endif
