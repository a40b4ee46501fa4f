// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDisplayStage
 * @brief The stage that shows a layer as the picture.
 *
 * Depth, range, normals and albedo are shown directly from the G-buffer's words. Ids, positions and
 * arrays, whose meaning only the CPU knows, are read back first. Scalars go through a colour map
 * over Range, vectors are shown as 0.5 v + 0.5, ids as distinct colours; light (color, light) by
 * the sRGB curve, from 0 to 1 or over Range: `color` is the colour before tone.
 */
#ifndef vtkRelievoDisplayStage_h
#define vtkRelievoDisplayStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"
#include "vtkRelievoText.h" // for names that are given

#include <memory> // for the internals
#include <string> // for the layer

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoDisplayStage : public vtkRelievoStage
{
public:
  static vtkRelievoDisplayStage* New();
  vtkTypeMacro(vtkRelievoDisplayStage, vtkRelievoStage);

  ///@{
  /** Name of the layer to show; "" (default) shows the picture itself. */
  void SetLayer(RELIEVO_TEXT name);
  std::string GetLayer() { return this->Layer; }
  const char* GetLayerOrNull() { return this->Layer.empty() ? nullptr : this->Layer.c_str(); }
  ///@}

  ///@{
  /**
   * Values shown as the first and the last colour, for scalar layers. Default (0, 0): from the near
   * to the far plane for depth and range, the finite extremes for arrays.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  /**
   * Values that the last frame showed as the first and the last colour of a scalar layer; of
   * several components, those of the first. Infinite where no pixel has a value.
   */
  vtkGetVector2Macro(ShownRange, double);

  /**
   * Whether the last frame showed a layer that has one value in all pixels; not known, and false,
   * of depth, range, normals and albedo.
   */
  vtkGetMacro(Same, bool);

  ///@{
  /**
   * Shows scalar layers in grey (or as raw values in a float framebuffer) instead of colours.
   * Default off.
   */
  vtkSetMacro(Grey, bool);
  vtkGetMacro(Grey, bool);
  vtkBooleanMacro(Grey, bool);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoDisplayStage();
  ~vtkRelievoDisplayStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;

  std::string Layer;
  double Range[2] = { 0.0, 0.0 };
  double ShownRange[2] = { 0.0, 0.0 };
  bool Same = false;
  bool Grey = false;

private:
  vtkRelievoDisplayStage(const vtkRelievoDisplayStage&) = delete;
  void operator=(const vtkRelievoDisplayStage&) = delete;

  // The colours of the layer, made on the CPU, as a texture; false if the layer cannot be read.
  bool UploadColors(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
