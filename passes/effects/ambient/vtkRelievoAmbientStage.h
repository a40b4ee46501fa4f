// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoAmbientStage
 * @brief Ambient occlusion by rays: the layer `ambient`, the share of the sky that a surface sees,
 * and the picture darkened by it.
 *
 * From the place that each pixel shows, rays go into the hemisphere about the triangle's normal, on
 * the side that the eye sees, past the triangles of the scene (as those of exact shadows do). The
 * layer is the share of them that nothing stops: 1 the whole sky, also where there is no surface; 0
 * nothing of it. Its error falls with the rays' number: 1/64 (rms) at 64 of them.
 *
 * Opaque surfaces that are made of triangles hide the sky, those outside the view included; what is
 * translucent hides nothing, and is not darkened unless it catches shadows. Points, lines, volumes
 * and cut-out surfaces, which rays cannot follow, hide nothing either. Processes that draw together
 * (vtkRelievoFramePass::SetController) each hold the triangles of all.
 *
 * The picture is darkened (Enabled) where all that VTK has drawn is in it: lights, ambient light
 * and environments together, since VTK's shaders add them up. What lamps (vtkRelievoLampsStage),
 * markers, lines and fog add comes later and is not darkened.
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
  /** How much of the light goes where no sky is seen, 0 to 1. Default 1. */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /** World units beyond which nothing hides the sky, at most 1e9; 0, the default: no limit. */
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
   * How parts of the sky count: COSINE (default), by the cosine to the normal, as the light of an
   * even sky arrives; UNIFORM, by their solid angles.
   */
  vtkSetClampMacro(Weighting, int, COSINE, UNIFORM);
  vtkGetMacro(Weighting, int);
  void SetWeightingToCosine() { this->SetWeighting(COSINE); }
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  ///@}

  ///@{
  /**
   * Rays of each pixel in all, 1 to 4096, and how many of them each frame follows, 1 to 64; the
   * first is rounded up to whole frames. Frames in which nothing else changes show the mean of
   * those so far; vtkRelievoFramePass::GetSamplesLeft says how many frames are missing. Default 64
   * and 4.
   */
  vtkSetClampMacro(Samples, int, 1, 4096);
  vtkGetMacro(Samples, int);
  vtkSetClampMacro(SamplesPerFrame, int, 1, 64);
  vtkGetMacro(SamplesPerFrame, int);
  ///@}

  ///@{
  /** Whether each picture waits for all rays. Default off. */
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
  std::vector<std::string> GetReadsFor(
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
