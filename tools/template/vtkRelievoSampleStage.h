// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSampleStage
 * @brief A stage that fades distant surfaces towards a colour.
 *
 * The fraction of the colour grows linearly with depth, from 0 at the near plane to Strength at the
 * far plane, and is mixed in linear light; the background stays unchanged.
 */
#ifndef vtkRelievoSampleStage_h
#define vtkRelievoSampleStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the drawing half

class vtkRelievoScreenQuad;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoSampleStage : public vtkRelievoStage
{
public:
  static vtkRelievoSampleStage* New();
  vtkTypeMacro(vtkRelievoSampleStage, vtkRelievoStage);

  ///@{
  /** Fraction of the colour at the far plane, from 0 (the stage does not run) to 1. Default 0.5. */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /** The colour of distant surfaces: red, green, blue from 0 to 1, sRGB. Default white. */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoSampleStage();
  ~vtkRelievoSampleStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;

  double Strength = 0.5;
  double Color[3] = { 1.0, 1.0, 1.0 };

private:
  vtkRelievoSampleStage(const vtkRelievoSampleStage&) = delete;
  void operator=(const vtkRelievoSampleStage&) = delete;

  std::unique_ptr<vtkRelievoScreenQuad> Quad;
};

#endif
