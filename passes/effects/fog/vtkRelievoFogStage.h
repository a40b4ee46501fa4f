// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFogStage
 * @brief Fog in spheres, from data: over the picture, and its transmittance as the layer `fog`.
 *
 * The ray of each pixel crosses a sphere along its chord, from the eye to the visible surface; in
 * the background the ray does not end. In parallel projection rays begin at depth 0, or at the near
 * plane if that lies behind.
 *
 * Modes:
 * - BEER (default): transmittance e^(-density length) (Beer and Lambert).
 * - CHORD: transmittance 1 - density length / (2 radius), at least 0; the classic.
 *
 * Where spheres overlap:
 * - SUM (default): optical depths add up, so transmittances multiply; colours are mixed by optical
 *   depth, independent of order.
 * - DOMINANT: only the sphere with the least transmittance counts.
 *
 * The picture is color T + fog (1 - T), in linear light, where T is the transmittance; also over
 * the background, whose alpha grows by that of the fog. Translucent surfaces are composited
 * afterwards (vtkRelievoBlendStage), covered by the fog in front of the nearest one.
 */
#ifndef vtkRelievoFogStage_h
#define vtkRelievoFogStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPointStage.h"

#include <memory> // for the drawing half

class vtkRelievoSphereRays;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoFogStage : public vtkRelievoPointStage
{
public:
  static vtkRelievoFogStage* New();
  vtkTypeMacro(vtkRelievoFogStage, vtkRelievoPointStage);

  enum Modes
  {
    BEER = 0,
    CHORD = 1
  };

  ///@{
  /** Transmittance along a chord: BEER (default) or CHORD. */
  vtkSetClampMacro(Mode, int, BEER, CHORD);
  vtkGetMacro(Mode, int);
  void SetModeToBeer() { this->SetMode(BEER); }
  void SetModeToChord() { this->SetMode(CHORD); }
  ///@}

  enum Overlaps
  {
    SUM = 0,
    DOMINANT = 1
  };

  ///@{
  /** Transmittance of overlapping spheres: SUM (default) or DOMINANT. */
  vtkSetClampMacro(Overlap, int, SUM, DOMINANT);
  vtkGetMacro(Overlap, int);
  void SetOverlapToSum() { this->SetOverlap(SUM); }
  void SetOverlapToDominant() { this->SetOverlap(DOMINANT); }
  ///@}

  VTK_NEWINSTANCE vtkRelievoPointValues* NewPoints() override;
  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoFogStage();
  ~vtkRelievoFogStage() override;

  const char* GetFailure() const override { return "There is no fog"; }
  void Describe(vtkRelievoStageDescription& description) override;
  void Synchronize(vtkRelievoFrameContext& context) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  std::string DrawBeforeTranslucent(
    vtkRelievoFrameContext& context, const vtkRelievoSphereRays& rays);
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

  int Mode = BEER;
  int Overlap = SUM;
  bool DrawnDepthSuffices = false; // for the picture of this frame

private:
  vtkRelievoFogStage(const vtkRelievoFogStage&) = delete;
  void operator=(const vtkRelievoFogStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
