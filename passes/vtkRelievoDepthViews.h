// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDepthViews
 * @brief Orthographic depth images of a renderer's scene from two or from six sides.
 *
 * Every Update() draws the layer depth again, by the frame and with the scene's own mappers and
 * buffers; no other renderer or window is made. The window's picture does not change, and the
 * renderer has its own camera and viewport afterwards, the window its tile, if it draws in tiles.
 *
 * Output: vtkMultiBlockDataSet of a vtkImageData per side, as vtkRelievoLayerSource makes them: the
 * float point array `depth`, +infinity in the background, and the field data of captures. Blocks
 * are named after the direction of looking: +x is seen from below. They are for input 1 of
 * vtkRelievoVoxelShell.
 *
 * Texels are squares around the middle of the box. A view has at most as many as the window has
 * pixels each way: its texels are larger then.
 *
 * Errors: a box that is not finite, and those of vtkRelievoLayerSource; the output is then empty.
 */
#ifndef vtkRelievoDepthViews_h
#define vtkRelievoDepthViews_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkSmartPointer.h"        // for the renderer

class vtkCamera;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoDepthViews : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRelievoDepthViews* New();
  vtkTypeMacro(vtkRelievoDepthViews, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer whose opaque, visible props are drawn; it must be in a render window. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** Whether all three axes are looked along, which is the default, or Axis alone. */
  vtkSetMacro(SixViews, bool);
  vtkGetMacro(SixViews, bool);
  vtkBooleanMacro(SixViews, bool);
  ///@}

  ///@{
  /** The axis of two views: 0, 1, or 2 (the default). */
  vtkSetClampMacro(Axis, int, 0, 2);
  vtkGetMacro(Axis, int);
  ///@}

  ///@{
  /**
   * The box that the views show: x, y and z, each from and to. While a pair is not in order, as by
   * default (1, -1, ...), it is that of all visible props. Surfaces outside it are seen too.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /** Side of the texels in world units. Default 0: by Resolution. */
  vtkSetClampMacro(TexelSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TexelSize, double);
  ///@}

  ///@{
  /** Texels along the longest side of the box. Default is 100. */
  vtkSetClampMacro(Resolution, int, 1, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  /** Always newer than before, because the scene may change without notice. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoDepthViews();
  ~vtkRelievoDepthViews() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoDepthViews(const vtkRelievoDepthViews&) = delete;
  void operator=(const vtkRelievoDepthViews&) = delete;

  bool GetBoxes(double box[6], double seen[6]);
  void Aim(vtkCamera* camera, int axis, int sign, const double box[6], const double seen[6]);

  vtkSmartPointer<vtkRenderer> Renderer;
  bool SixViews = true;
  int Axis = 2;
  double Bounds[6] = { 1., -1., 1., -1., 1., -1. };
  double TexelSize = 0.;
  int Resolution = 100;
};

#endif
