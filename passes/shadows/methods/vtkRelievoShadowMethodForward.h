// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Transforms the maps' samples into the camera's view (H. Zhang, Forward shadow mapping, 1998); see
// vtkRelievoForwardMasks. Pixels without samples use the maps.
#ifndef vtkRelievoShadowMethodForward_h
#define vtkRelievoShadowMethodForward_h

#include "vtkRelievoForwardMasks.h"
#include "vtkRelievoShadowMethod.h"

#include <cstdint>

class vtkLight;

class vtkRelievoShadowMethodForward : public vtkRelievoShadowMethod
{
public:
  int Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer) override;
  std::string GetFault() const override { return this->Fault; }
  void Settle(const vtkRelievoShadowContext& work) override;
  void Forget() override { this->Drawn = {}; }
  void Unbind() override { this->Masks.Unbind(); }
  std::string GetShader() const override { return "shadow/forward.glsl"; }
  std::string GetVolumeShader() const override { return "shadow/map.glsl"; }
  void SetFrameUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work) const override;
  void SetActorUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor) const override;
  vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const override;
  vtkIdType GetBytes() const override { return this->Masks.GetBytes(); }
  void Release(vtkWindow* window) override { this->Masks.Release(window); }

private:
  struct State // input of the masks
  {
    glm::dmat4 WorldToNDC{ 0.0 };
    std::vector<std::uint64_t> Surfaces;
    std::vector<bool> Culling;
    std::vector<vtkLight*> Lights; // for comparison only
    double Bias = -1.0;

    bool operator==(const State& other) const;
  };

  vtkRelievoForwardMasks Masks;
  State Drawn;
  std::string Fault;
};

#endif
