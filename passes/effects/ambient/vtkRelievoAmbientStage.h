// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoAmbientStage
 * @brief Ambient occlusion by rays: the layer `ambient`, the visible share of the sky at each
 * surface, and the picture darkened by it.
 *
 * From each pixel's surface point, rays are traced through the scene's triangles (those of exact
 * shadows) into the hemisphere about the triangle's normal, on the side that faces the eye. The
 * layer is the share of rays that hit nothing: 1 where the whole sky is visible, or where there is
 * no surface; 0 where no sky is visible. The error falls with the number of rays: 1/64 (rms) at 64
 * rays.
 *
 * Opaque triangle meshes hide the sky, those outside the view included. Translucent surfaces hide
 * nothing, and are not darkened unless they catch shadows. Points, lines, volumes and cut-out
 * surfaces hide nothing either, since rays cannot intersect them. Processes that draw together
 * (vtkRelievoFramePass::SetController) each store the triangles of all processes.
 *
 * Enabled darkens the light of VTK's picture, except that of lights that cast shadows: ambient
 * light, environments, fill lights and lights without shadows; all of it on surfaces whose lights
 * are deferred, and where users have replaced parts of the fragment shader. Lamps
 * (vtkRelievoLampsStage), markers, lines and fog are added later and are not darkened.
 */
#ifndef vtkRelievoAmbientStage_h
#define vtkRelievoAmbientStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the drawing half

class vtkShaderProgram;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoAmbientStage : public vtkRelievoStage
{
public:
  static vtkRelievoAmbientStage* New();
  vtkTypeMacro(vtkRelievoAmbientStage, vtkRelievoStage);

  ///@{
  /**
   * Whether only surfaces that catch shadows are darkened, such as the ground of a preset. Default
   * off.
   */
  vtkSetMacro(OnlyCatchers, bool);
  vtkGetMacro(OnlyCatchers, bool);
  vtkBooleanMacro(OnlyCatchers, bool);
  ///@}

  ///@{
  /** Share of the light removed where no sky is visible, 0 to 1. Default 1. */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Distance beyond which nothing hides the sky, in world units, at most 1e9; 0 (default): no
   * limit.
   */
  vtkSetClampMacro(Radius, double, 0.0, 1e9);
  vtkGetMacro(Radius, double);
  ///@}

  enum Weightings
  {
    COSINE = 0,
    UNIFORM = 1
  };

  ///@{
  /**
   * Weight of each part of the sky: COSINE (default), by the cosine of its angle to the normal, for
   * the light of a uniform sky; UNIFORM, by solid angle.
   */
  vtkSetClampMacro(Weighting, int, COSINE, UNIFORM);
  vtkGetMacro(Weighting, int);
  void SetWeightingToCosine() { this->SetWeighting(COSINE); }
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  ///@}

  ///@{
  /**
   * Total rays per pixel, 1 to 4096, rounded up to whole frames; and rays per pixel traced in each
   * frame, 1 to 64. Frames in which nothing else changes show the mean of all rays so far;
   * vtkRelievoFramePass::GetSamplesLeft returns the number of frames still needed. Default 64 and
   * 4.
   */
  vtkSetClampMacro(Samples, int, 1, 4096);
  vtkGetMacro(Samples, int);
  vtkSetClampMacro(SamplesPerFrame, int, 1, 64);
  vtkGetMacro(SamplesPerFrame, int);
  ///@}

  ///@{
  /** Whether each frame traces all rays. Default off. */
  vtkSetMacro(AtOnce, bool);
  vtkGetMacro(AtOnce, bool);
  vtkBooleanMacro(AtOnce, bool);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoAmbientStage();
  ~vtkRelievoAmbientStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

  bool OnlyCatchers = false;
  double Strength = 1.0;
  double Radius = 0.0;
  int Weighting = COSINE;
  int Samples = 64;
  int SamplesPerFrame = 4;
  bool AtOnce = false;

private:
  vtkRelievoAmbientStage(const vtkRelievoAmbientStage&) = delete;
  void operator=(const vtkRelievoAmbientStage&) = delete;

  std::string BeginRays(vtkRelievoFrameContext& context);
  void TellRays(vtkShaderProgram* program, const vtkRelievoFrameContext& context);
  std::string DrawShare(vtkRelievoFrameContext& context);
  std::string DrawColor(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
