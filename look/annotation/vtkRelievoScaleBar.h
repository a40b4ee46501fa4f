// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoScaleBar
 * @brief Shows a round length of the world at the lower right of the picture.
 *
 * Add it to a renderer like any prop (vtkRenderer::AddViewProp): a horizontal bar with its length
 * above it, drawn over the picture, without light or tone, and in no layer. It lays itself out in
 * each frame for the renderer's camera and size, also in tiles. The label ends with the unit of the
 * world's lengths. Bar and label have an edge of the other colour, black or white; the least size
 * of the label is 9 pixels, unless TextSize is set.
 *
 * In a parallel projection the bar is accurate everywhere, to half a pixel. In perspective near
 * objects look larger: the bar is accurate at Depth, across the view.
 *
 * Errors: a Length wider than the picture is reported once, and no bar is drawn.
 */
#ifndef vtkRelievoScaleBar_h
#define vtkRelievoScaleBar_h

#include "vtkRelievoLookModule.h" // for the export macro
#include "vtkRelievoOverlayBar.h"

#include <string> // for texts

class vtkRenderer;

class VTKRELIEVOLOOK_EXPORT vtkRelievoScaleBar : public vtkRelievoOverlayBar
{
public:
  static vtkRelievoScaleBar* New();
  vtkTypeMacro(vtkRelievoScaleBar, vtkRelievoOverlayBar);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The bar's length in world units. Default 0: 1, 2 or 5 times a power of ten, limited by Share.
   */
  vtkSetClampMacro(Length, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** The largest share of the picture's width for a round length, 0.01 to 0.9. Default 0.2. */
  vtkSetClampMacro(Share, double, 0.01, 0.9);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * In perspective, the distance along the view direction from the camera at which the bar is
   * accurate, in world units. Default 0: the distance of the camera's focal point.
   */
  vtkSetClampMacro(Depth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Depth, double);
  ///@}

  /** The bar's length in world units in a renderer, which must be in a window; otherwise 0. */
  double GetShownLength(vtkRenderer* renderer);

  /** The text above the bar: the length as a decimal number, and the unit; empty without a bar. */
  std::string GetLabel(vtkRenderer* renderer);

  /** Called by the renderer. */
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkRelievoScaleBar();
  ~vtkRelievoScaleBar() override;

  double Length = 0.0;
  double Share = 0.2;
  double Depth = 0.0;
  double Refused = 0.0; // the length last reported as too long

private:
  vtkRelievoScaleBar(const vtkRelievoScaleBar&) = delete;
  void operator=(const vtkRelievoScaleBar&) = delete;
};

#endif
