// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Traces a ray from each pixel's own place to the light, past the casters' triangles. Casters other
// than triangles are drawn into maps, like with the method map, and block the light that rays let
// pass.
#ifndef vtkRelievoShadowMethodExact_h
#define vtkRelievoShadowMethodExact_h

#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoTreeBuffer.h"
#include "vtkRelievoVisibilityPrepass.h"

class vtkRelievoShadowMethodExact : public vtkRelievoShadowMethod
{
public:
  std::string Prepare(vtkRelievoShadowContext& work, vtkRenderer* renderer) override;
  int Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer) override;
  void Unbind() override
  {
    this->Tree.Unbind();
    this->Seen.Unbind();
  }
  std::string GetShader() const override { return "shadow/exact.glsl"; }
  bool Traces() const override { return true; }
  bool Colors() const override { return this->Colored; }
  void SetFrameUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work) const override;
  void SetVolumeUniforms(vtkShaderProgram* program, const vtkRelievoShadowContext& work,
    const glm::dmat4& placeToView) const override;
  std::vector<vtkActor*> GetFound(std::size_t lights) const override;
  void SetActorUniforms(
    vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor) const override;
  // Farness for a vtkRelievoShadowDemand of the frame's scene: the ratio of the largest rounded
  // coordinate to the view's size. `reach`: of vtkRelievoPropMeshes::GetRoundedReach, the casters'
  // largest.
  static double GetFarness(const vtkRelievoShadowContext& work, double reach);

  vtkRelievoShadowEstimate Estimate(const vtkRelievoShadowDemand& demand) const override;
  std::string GetReport() const override;
  vtkIdType GetBytes() const override { return this->Tree.GetBytes() + this->Seen.GetBytes(); }
  void Forget() override { this->Seen.Forget(); }
  void Release(vtkWindow* window) override
  {
    this->Tree.Release(window);
    this->Seen.Release(window);
  }

private:
  struct Rays // input of a shader
  {
    glm::mat4 ToLocal{ 1.f };
    glm::vec3 Center{ 0.f }; // eye space
    glm::vec2 Blur{ 0.f };
    std::vector<glm::vec4> Sources;
  };
  void FindSurfaces(const vtkRelievoShadowContext& work);
  Rays GetRays(const vtkRelievoShadowContext& work) const;
  void Tell(vtkShaderProgram* program, const Rays& rays, bool walks) const;

  vtkRelievoTreeBuffer Tree;
  vtkRelievoVisibilityPrepass Seen;
  double Farness = 0.0;            // of this frame
  double Rounding = 0.0;           // of coordinates, in pixels
  std::size_t InMaps = 0;          // casters that rays cannot trace
  std::vector<vtkActor*> Surfaces; // of this frame, with verdicts found beforehand
  std::vector<vtkActor*> Found;    // and those of glyphs
  bool Colored = false;            // some colour the transmitted light
  bool Alone = false;              // each of their pixels shows only the surface at its centre
};

#endif
