// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoScaleBar
 * @brief Shows how long a round length of the world is in the picture, at its lower right.
 *
 * It is added to a renderer like any prop (vtkRenderer::AddViewProp): a horizontal bar and its
 * length above it, drawn over the picture, without light or tone, and in no layer. Each frame is
 * laid out anew for the renderer's camera and size, also in tiles. Both are black or white,
 * whatever is read better on the renderer's background, with an edge of the other, and as large as
 * fits the shorter side of the picture.
 *
 * In a parallel projection the bar is right everywhere, to half a pixel. In perspective
 * what is near looks larger: there it is right at Depth, for what lies across the view.
 *
 * Errors: a Length that is wider than the picture is named once, and no bar is drawn.
 */
#ifndef vtkRelievoScaleBar_h
#define vtkRelievoScaleBar_h

#include "vtkActor2D.h"
#include "vtkRelievoLookModule.h" // for the export macro
#include "vtkRelievoText.h"       // for texts

#include <memory> // for the internals
#include <string> // for texts

class vtkRenderer;

class VTKRELIEVOLOOK_EXPORT vtkRelievoScaleBar : public vtkActor2D
{
public:
  static vtkRelievoScaleBar* New();
  vtkTypeMacro(vtkRelievoScaleBar, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The unit of the world's lengths, in UTF-8, which the label ends with. Default: none. */
  void SetUnit(RELIEVO_TEXT unit);
  std::string GetUnit();
  ///@}

  ///@{
  /** The bar's length in world units. Default 0: 1, 2 or 5 times a power of ten, by Share. */
  vtkSetClampMacro(Length, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** The share of the picture's width that a round length has at most, 0.01 to 0.9. Default 0.2. */
  vtkSetClampMacro(Share, double, 0.01, 0.9);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * In perspective, how far along the view direction from the camera the bar is right, in world
   * units. Default 0: as far as the camera's focal point.
   */
  vtkSetClampMacro(Depth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Depth, double);
  ///@}

  enum Inks
  {
    INK_AUTOMATIC,
    INK_BLACK,
    INK_WHITE
  };

  ///@{
  /** The colour of bar and label; their edges have the other. Default: by the background. */
  vtkSetClampMacro(Ink, int, INK_AUTOMATIC, INK_WHITE);
  vtkGetMacro(Ink, int);
  ///@}

  /** The length in world units that the bar has in a renderer, which is in a window; else 0. */
  double GetShownLength(vtkRenderer* renderer);

  /** The text above the bar: the shown length as a decimal number, and the unit; else empty. */
  std::string GetLabel(vtkRenderer* renderer);

  ///@{
  /** Called by the renderer. */
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkRelievoScaleBar();
  ~vtkRelievoScaleBar() override;

  double Length = 0.0;
  double Share = 0.2;
  double Depth = 0.0;
  int Ink = INK_AUTOMATIC;

private:
  vtkRelievoScaleBar(const vtkRelievoScaleBar&) = delete;
  void operator=(const vtkRelievoScaleBar&) = delete;

  struct Internals;
  const std::unique_ptr<Internals> Internal;
};

#endif
