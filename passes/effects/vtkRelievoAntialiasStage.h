// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoAntialiasStage
 * @brief The stage that smooths edges: the picture is the mean of samples spread over each pixel.
 *
 * Each frame in which nothing else changes draws one more sample, with everything in it, so that
 * shadows, textures and what other stages add are smoothed as well as edges; frames that wait for
 * samples (vtkRelievoFramePass::SetWaitForSamples) draw them all. Each pixel is then the mean of
 * the linear light that falls on its square (Halton's sequence, 1960). Samples of soft shadows are
 * the same ones, and cost nothing more.
 *
 * Layers have one sample, at the centre of each pixel: frames that hand out layers are not
 * smoothed, and neither are those that show one. Pictures that several processes draw together are
 * put together by depth, of which a pixel has one: they are not smoothed either.
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
   * Samples of each pixel, 1 to 256; default 16.
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
