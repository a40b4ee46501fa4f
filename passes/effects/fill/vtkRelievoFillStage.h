// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFillStage
 * @brief Draws fill lights as one smooth light of all surroundings, with ambient occlusion.
 *
 * Fill lights are distant lights that are marked as such (SetLightFills). VTK's Phong and
 * Gouraud surfaces get the light of all of them by nine coefficients (R. Ramamoorthi, P. Hanrahan,
 * An Efficient Representation for Irradiance Environment Maps, SIGGRAPH 2001), which has no edges
 * where one of the lights ends. Where the scene hides its surroundings the light is weaker, by a
 * coarse grid of the visible sky. Other lights are not darkened.
 */
#ifndef vtkRelievoFillStage_h
#define vtkRelievoFillStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the internals

class vtkLight;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoFillStage : public vtkRelievoStage
{
public:
  static vtkRelievoFillStage* New();
  vtkTypeMacro(vtkRelievoFillStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Share of the fill lights removed where no sky is visible, 0 to 1. Default 0.6. */
  vtkSetClampMacro(Occlusion, double, 0.0, 1.0);
  vtkGetMacro(Occlusion, double);
  ///@}

  ///@{
  /**
   * Whether a distant light is a fill light, which has no highlights and casts no shadow while the
   * stage is on. Default off, except for the presets' fill lights.
   */
  void SetLightFills(vtkLight* light, bool fills);
  bool GetLightFills(vtkLight* light);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoFillStage();
  ~vtkRelievoFillStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;

  double Occlusion = 0.6;

private:
  vtkRelievoFillStage(const vtkRelievoFillStage&) = delete;
  void operator=(const vtkRelievoFillStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
