// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoAntialiasStage
 * @brief The stage that smooths edges: the picture is the mean of samples spread over each pixel.
 *
 * Each frame in which nothing else changes draws one more sample of the whole picture, so that
 * shadows, textures and the effects of other stages are smoothed as well as edges; frames that wait
 * for samples (vtkRelievoFramePass::SetWaitForSamples) draw them all. Each pixel is then the mean
 * of the linear light that falls on its square (Halton's sequence, 1960). Soft shadows use the same
 * samples, at no further cost.
 *
 * Layers have one sample, at the centre of each pixel: frames that read or show layers are not
 * smoothed. Pictures drawn by several processes are composited by one depth per pixel: they are not
 * smoothed either.
 */
#ifndef vtkRelievoAntialiasStage_h
#define vtkRelievoAntialiasStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoAntialiasStage : public vtkRelievoStage
{
public:
  static vtkRelievoAntialiasStage* New();
  vtkTypeMacro(vtkRelievoAntialiasStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Samples per pixel, 1 to 256; default 16.
   */
  vtkSetClampMacro(Samples, int, 1, 256);
  vtkGetMacro(Samples, int);
  ///@}

protected:
  vtkRelievoAntialiasStage();
  ~vtkRelievoAntialiasStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;

  int Samples = 16;

private:
  vtkRelievoAntialiasStage(const vtkRelievoAntialiasStage&) = delete;
  void operator=(const vtkRelievoAntialiasStage&) = delete;
};

#endif
