// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDisplayStage
 * @brief The stage that shows a layer as the picture.
 *
 * Depth, range, normals and albedo are shown directly from the G-buffer's words. Ids, positions and
 * arrays, which only the CPU can decode, are read back first. Scalars go through Colormap over
 * Range, vectors are shown as 0.5 v + 0.5, ids as distinct colours; light (color, light) by the
 * sRGB curve, from 0 to 1 or over Range: `color` is the colour before tone mapping.
 */
#ifndef vtkRelievoDisplayStage_h
#define vtkRelievoDisplayStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"
#include "vtkRelievoText.h" // for names that are given

#include <array>  // for the colours
#include <memory> // for the internals
#include <string> // for the layer
#include <vector> // for the colours

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
   * Values shown in the first and the last colour of a scalar layer. Default (0, 0): from the least
   * to the greatest visible finite value. For depth and range, a flat ground far wider than all
   * other objects counts only within their range; a picture in tiles takes the range of the scene's
   * bounds, and a picture drawn by several processes that of the clipping planes.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  /**
   * Values shown in the first and the last colour of a scalar layer in the last frame; for several
   * components, those of the first one. Infinite if no pixel has a value.
   */
  vtkGetVector2Macro(ShownRange, double);

  /** Number of components of the layer shown in the last frame; 0 if none was shown. */
  vtkGetMacro(ShownComponents, int);

  /**
   * Whether all pixels of the layer shown in the last frame have one value; always false for depth,
   * range, normals and albedo, where this is not determined.
   */
  vtkGetMacro(Same, bool);

  enum Colormaps
  {
    VIRIDIS = 0,
    COOL_WARM = 1,
    GREY = 2,
    HOT = 3,
    RAINBOW = 4,
    EMBER = 5,
    OCEAN = 6,
    BLUE_ORANGE = 7,
    GREEN_PURPLE = 8,
    PHASE = 9,
    CATEGORIES = 10
  };

  ///@{
  /** The colour map of scalar layers. Default VIRIDIS. */
  vtkSetClampMacro(Colormap, int, VIRIDIS, CATEGORIES);
  vtkGetMacro(Colormap, int);
  ///@}

  ///@{
  /** Shows the greatest value in the map's first colour. Default off. */
  vtkSetMacro(Reversed, bool);
  vtkGetMacro(Reversed, bool);
  vtkBooleanMacro(Reversed, bool);
  ///@}

  ///@{
  /**
   * Shows scalar layers in grey (or as raw values in a float framebuffer) instead of colours.
   * Default off.
   */
  vtkSetMacro(Grey, bool);
  vtkGetMacro(Grey, bool);
  vtkBooleanMacro(Grey, bool);
  ///@}

  /**
   * Whether one colour scale describes the layer: not for ids, colours, vectors and arrays of three
   * or more components.
   */
  bool HasScale();

  ///@{
  /**
   * Name of the layer's colour map (see vtkRelievoColormaps), and whether it is reversed: grey for
   * shares, and if Grey is on.
   */
  std::string GetShownColormap();
  bool GetShownReversed();
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
  int ShownComponents = 0;
  bool Same = false;
  int Colormap = VIRIDIS;
  bool Reversed = false;
  bool Grey = false;

private:
  vtkRelievoDisplayStage(const vtkRelievoDisplayStage&) = delete;
  void operator=(const vtkRelievoDisplayStage&) = delete;

  // Makes the layer's colours on the CPU, as a texture; false if the layer cannot be read.
  bool UploadColors(vtkRelievoFrameContext& context);

  // Reports an error of the layer once and marks the stage as failed; false if there is an error.
  bool IsGood(const std::string& error);

  // Uploads the colour map as a texture of one row.
  void UploadMap(vtkRelievoFrameContext& context);

  // The colours of the map.
  std::vector<std::array<float, 3>> GetColors() const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
