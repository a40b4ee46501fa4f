// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoOverlayBar
 * @brief A bar with texts over the picture: the unit, the size and the colour of its texts.
 *
 * The superclass of vtkRelievoColorBar and vtkRelievoScaleBar, which draw it. The bar lies over the
 * picture only, without light or tone, and in no layer.
 */
#ifndef vtkRelievoOverlayBar_h
#define vtkRelievoOverlayBar_h

#include "vtkActor2D.h"
#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoText.h"          // for texts

#include <memory> // for the pen
#include <string> // for texts

class vtkRelievoOverlayPen;
class vtkRenderer;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoOverlayBar : public vtkActor2D
{
public:
  vtkAbstractTypeMacro(vtkRelievoOverlayBar, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The unit of the bar's values, in UTF-8. Default: none. */
  void SetUnit(RELIEVO_TEXT unit);
  std::string GetUnit();
  ///@}

  ///@{
  /** Height of the font, pixels. Default 0: by the shorter side of the picture. */
  vtkSetClampMacro(TextSize, double, 0.0, 1000.0);
  vtkGetMacro(TextSize, double);
  ///@}

  enum Inks
  {
    INK_AUTOMATIC,
    INK_BLACK,
    INK_WHITE
  };

  ///@{
  /** The colour of texts and lines. Default: black or white, whichever contrasts more with the
   * background. */
  vtkSetClampMacro(Ink, int, INK_AUTOMATIC, INK_WHITE);
  vtkGetMacro(Ink, int);
  ///@}

  ///@{
  /** Called by the renderer; the bar is drawn by RenderOverlay. */
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkRelievoOverlayBar();
  ~vtkRelievoOverlayBar() override;

  // The grey of texts and lines in a renderer, 0 or 1.
  double GetShownInk(vtkRenderer* renderer) const;

  std::string Unit;
  double TextSize = 0.0;
  int Ink = INK_AUTOMATIC;
  const std::unique_ptr<vtkRelievoOverlayPen> Pen;

private:
  vtkRelievoOverlayBar(const vtkRelievoOverlayBar&) = delete;
  void operator=(const vtkRelievoOverlayBar&) = delete;
};

#endif
