// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDisplayStage
 * @brief The stage that shows a layer as the picture.
 *
 * Depth, range, normals and albedo are shown directly from the G-buffer's words. Ids, positions and
 * arrays, whose meaning only the CPU knows, are read back first. Scalars go through Colormap over
 * Range, vectors are shown as 0.5 v + 0.5, ids as distinct colours; light (color, light) by
 * the sRGB curve, from 0 to 1 or over Range: `color` is the colour before tone.
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
   * Values shown as the first and the last colour, for scalar layers. Default (0, 0): from the
   * least to the greatest finite value that is seen. Of depth and range, a ground that is flat and
   * far wider than all else counts only as near and as far as the rest is; of a picture in tiles
   * they are those of the scene's bounds, of one that several processes draw together those of the
   * clipping planes.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  /**
   * Values that the last frame showed as the first and the last colour of a scalar layer; of
   * several components, those of the first. Infinite where no pixel has a value.
   */
  vtkGetVector2Macro(ShownRange, double);

  /** How many components the layer has that the last frame showed; 0 of none. */
  vtkGetMacro(ShownComponents, int);

  /**
   * Whether the last frame showed a layer that has one value in all pixels; not known, and false,
   * of depth, range, normals and albedo.
   */
  vtkGetMacro(Same, bool);

  enum Colormaps
  {
    VIRIDIS = 0,
    COOL_WARM = 1,
    GREY = 2,
    HOT = 3,
    RAINBOW = 4
  };

  ///@{
  /** The colour map of scalar layers. Default VIRIDIS. */
  vtkSetClampMacro(Colormap, int, VIRIDIS, RAINBOW);
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
   * Whether one row of colours tells all values of the layer: not of ids, colours, vectors and
   * arrays of three components and more.
   */
  bool HasScale();

  ///@{
  /**
   * The colour map in which the layer is shown, a name of vtkRelievoColormaps, and whether it is
   * turned round: grey for shares, and where Grey is on.
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

  // The colours of the layer, made on the CPU, as a texture; false if the layer cannot be read.
  bool UploadColors(vtkRelievoFrameContext& context);

  // Says once what is wrong with the layer, and that the stage failed; false if something is.
  bool IsGood(const std::string& wrong);

  // The colour map as a texture of one row.
  void UploadMap(vtkRelievoFrameContext& context);

  // Those of the map.
  std::vector<std::array<float, 3>> GetColors() const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
