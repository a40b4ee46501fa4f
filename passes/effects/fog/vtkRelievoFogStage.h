// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFogStage
 * @brief Fog in spheres, from data: over the picture, and as the layer `fog`, what it lets through.
 *
 * The ray of each pixel runs through a sphere along its chord, from the eye to the surface that the
 * pixel shows; where nothing is shown it does not end. In parallel projection rays begin at depth
 * 0, or at the near plane where that is behind.
 *
 * Modes:
 * - BEER (default): e^(-density length) of the light passes (Beer and Lambert).
 * - CHORD: 1 - density length / (2 radius) passes, the classic; 0 at the least.
 *
 * Where spheres overlap:
 * - SUM (default): optical depths add up, so what they let through is multiplied; their colours are
 *   mixed by optical depth, in any order.
 * - DOMINANT: only the one that lets least through counts.
 *
 * The picture is color T + fog (1 - T), in linear light, where T is what passes; also over the
 * background, whose alpha grows by that of the fog. What is translucent is composited afterwards
 * (vtkRelievoBlendStage), and is covered by the fog before its nearest surface.
 */
#ifndef vtkRelievoFogStage_h
#define vtkRelievoFogStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPointStage.h"

#include <memory> // for what is drawn

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
  /** How much passes of a chord: BEER (default) or CHORD. */
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
  /** What passes where spheres overlap: SUM (default) or DOMINANT. */
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
  std::vector<std::string> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  std::string DrawBeforeTranslucent(
    vtkRelievoFrameContext& context, const vtkRelievoSphereRays& rays);
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

  int Mode = BEER;
  int Overlap = SUM;
  bool DrawnDepthSuffices = false; // in this frame, for its picture

private:
  vtkRelievoFogStage(const vtkRelievoFogStage&) = delete;
  void operator=(const vtkRelievoFogStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
