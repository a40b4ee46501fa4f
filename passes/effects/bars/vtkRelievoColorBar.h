// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoColorBar
 * @brief Shows the colours of a map with their values, over the picture.
 *
 * Add it to a renderer like any prop (vtkRenderer::AddViewProp); it has no light and no tone, and
 * is in no layer. It lays itself out in each frame for the picture's size, also in tiles. The
 * colours are smooth if the map is: one for each row of pixels. Values are at 1, 2 or 5 times
 * powers of ten; long numbers share a factor, which is in the title with the unit, in parentheses.
 * The least size of texts is 11 pixels, unless TextSize is set. Texts are in DejaVu Sans if
 * the system has it (or the environment variable RELIEVO_FONT names a font's file), else in VTK's
 * own font, which has no superscripts and few Greek letters.
 *
 * Errors: none; without a map nothing is drawn.
 */
#ifndef vtkRelievoColorBar_h
#define vtkRelievoColorBar_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoOverlayBar.h"
#include "vtkRelievoText.h" // for texts

#include <memory> // for the internals
#include <string> // for texts

class vtkRenderer;
class vtkScalarsToColors;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoColorBar : public vtkRelievoOverlayBar
{
public:
  static vtkRelievoColorBar* New();
  vtkTypeMacro(vtkRelievoColorBar, vtkRelievoOverlayBar);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The map, over its own range. Default: none. */
  void SetLookupTable(vtkScalarsToColors* map);
  vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /** The name of the values, in UTF-8; above the bar. Default: none. */
  void SetTitle(RELIEVO_TEXT title);
  std::string GetTitle();
  ///@}

  ///@{
  /** Texts in place of the values of the first and the last colour. Default: none, ticks. */
  void SetEnds(RELIEVO_TEXT first, RELIEVO_TEXT last);
  ///@}

  enum Places
  {
    PLACE_RIGHT,
    PLACE_LEFT,
    PLACE_BOTTOM,
    PLACE_TOP
  };

  ///@{
  /** The edge of the picture beside which the bar is; horizontal at the bottom and the top. */
  vtkSetClampMacro(Place, int, PLACE_RIGHT, PLACE_TOP);
  vtkGetMacro(Place, int);
  ///@}

  ///@{
  /** The bar's length as a share of the picture along it, 0.1 to 0.9. Default 0.5. */
  vtkSetClampMacro(Share, double, 0.1, 0.9);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /** The middle of bar and texts along the picture's edge as a share, 0 to 1. Default 0.5. */
  vtkSetClampMacro(Middle, double, 0.0, 1.0);
  vtkGetMacro(Middle, double);
  ///@}

  ///@{
  /** Number of colours of a map in steps; up to 12, values are where the colours change. Default
   * 0. */
  vtkSetClampMacro(Steps, int, 0, 256);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /** Boxes with the colours of values below and above the range, and of NaN. Default: off. */
  vtkSetMacro(BelowBox, bool);
  vtkGetMacro(BelowBox, bool);
  vtkBooleanMacro(BelowBox, bool);
  vtkSetMacro(AboveBox, bool);
  vtkGetMacro(AboveBox, bool);
  vtkBooleanMacro(AboveBox, bool);
  vtkSetMacro(NanBox, bool);
  vtkGetMacro(NanBox, bool);
  vtkBooleanMacro(NanBox, bool);
  ///@}

  ///@{
  /** A dark ground under bar and texts, on which white is readable over any picture. Default: off.
   */
  vtkSetMacro(Backdrop, bool);
  vtkGetMacro(Backdrop, bool);
  vtkBooleanMacro(Backdrop, bool);
  ///@}

  /**
   * A font file for all bars, grids and scale bars where neither RELIEVO_FONT nor the system gives
   * one. Has an effect before the first of them is drawn.
   */
  static void SetFallbackFont(RELIEVO_TEXT file);

  /**
   * The texts in a renderer, which must be in a window, one a line: the title, the values from the
   * first colour to the last, and those of boxes.
   */
  std::string GetTexts(vtkRenderer* renderer);

  /** Called by the renderer. */
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkRelievoColorBar();
  ~vtkRelievoColorBar() override;

  int Place = PLACE_RIGHT;
  double Share = 0.5;
  double Middle = 0.5;
  int Steps = 0;
  bool BelowBox = false;
  bool AboveBox = false;
  bool NanBox = false;
  bool Backdrop = false;

private:
  vtkRelievoColorBar(const vtkRelievoColorBar&) = delete;
  void operator=(const vtkRelievoColorBar&) = delete;

  struct Internals;
  const std::unique_ptr<Internals> Internal;
};

#endif
