// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLayerLegend
 * @brief The colour bar of the layer that the stage `display` shows as the picture.
 *
 * Add it to the renderer whose pass is the frame. It follows the stage in each frame, and is not
 * drawn if the stage shows nothing, or a layer whose colours are not a row, such as normals.
 */
#ifndef vtkRelievoLayerLegend_h
#define vtkRelievoLayerLegend_h

#include "vtkRelievoColorBar.h"
#include "vtkRelievoEffectsModule.h" // for the export macro

#include "vtkNew.h" // for the map

class vtkColorTransferFunction;
class vtkRelievoDisplayStage;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoLayerLegend : public vtkRelievoColorBar
{
public:
  static vtkRelievoLayerLegend* New();
  vtkTypeMacro(vtkRelievoLayerLegend, vtkRelievoColorBar);

  /**
   * Takes layer, colours and range from a stage, for a renderer that has no frame. `isDrawnHere`:
   * the stage drew the last picture and knows its values; otherwise a server did. Returns whether
   * there is anything to show.
   */
  bool Follow(vtkRelievoDisplayStage* stage, bool isDrawnHere = true);

  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkRelievoLayerLegend();
  ~vtkRelievoLayerLegend() override;

private:
  vtkRelievoLayerLegend(const vtkRelievoLayerLegend&) = delete;
  void operator=(const vtkRelievoLayerLegend&) = delete;

  bool Take(vtkRelievoDisplayStage* stage, bool isDrawnHere);
  void RenderAfterFrame(vtkObject* caller, unsigned long, void*);

  vtkNew<vtkColorTransferFunction> Colors;
  bool IsGiven = false;   // by Follow
  unsigned long Last = 0; // the observer of the renderer's frame
};

#endif
