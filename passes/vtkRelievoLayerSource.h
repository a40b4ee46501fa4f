// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLayerSource
 * @brief A renderer's layers as image data: depth, normals, positions, ids, arrays.
 *
 * Every Update() draws the layers again. The window's picture does not change unless the layer
 * `color` is requested, which renders the window.
 *
 * Output: vtkImageData with the viewport's size in pixels, row 0 at the bottom, and one point array
 * per layer, of the type and with the background that vtkRelievoLayerCatalogue says:
 * - color: the picture decoded from sRGB to linear light, 0 to 1; the background is the renderer's
 *   background colour with its own alpha (vtkViewport::GetBackgroundAlpha, 0 by default).
 * - shadow_N: visibility of light N of vtkRenderer::GetLights().
 * - actor is the index in vtkRenderer::GetActors(), block the flat index in a composite dataset (0
 *   for other data), cell the cell of the vtkPolyData that is drawn, or the input point of a glyph.
 * - arrays: float or double, background NaN.
 *
 * Field data: worldToCamera and worldToNDC (16 double, row by row, as vtkMatrix4x4), near, far,
 * relievo:origin (3 double: the camera's focal point, rounded to float), lights (one JSON string
 * each); and if the camera is a pinhole its calibration (vtkRelievoLensCamera): K and R (9 double,
 * row by row), t (3 double).
 *
 * Errors: no renderer or window, a renderer that draws nothing (DrawOff), no display, a layer that
 * does not exist, a size above the OpenGL limit.
 */
#ifndef vtkRelievoLayerSource_h
#define vtkRelievoLayerSource_h

#include "vtkErrorCode.h" // for the code of the error
#include "vtkImageAlgorithm.h"
#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkRelievoText.h"         // for names that are given
#include "vtkSmartPointer.h"        // for the renderer

#include <functional> // for views
#include <string>     // for names
#include <vector>     // for names

class vtkCamera;
class vtkImageData;
class vtkRelievoPass;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoLayerSource : public vtkImageAlgorithm
{
public:
  static vtkRelievoLayerSource* New();
  vtkTypeMacro(vtkRelievoLayerSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer whose layers are drawn; it must be in a render window. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The layers, by name, in the order of the output's arrays. */
  void AddLayer(RELIEVO_TEXT name);
  void RemoveAllLayers();
  int GetNumberOfLayers() { return static_cast<int>(this->Layers.size()); }
  std::string GetLayer(int i);
  ///@}

  ///@{
  /**
   * Whether the layer `color` is the frame's linear colour, unclamped, with the digits of half
   * floats or more, without texts and bars, and drawn without changing the window. Off (default),
   * it is the window's picture of 8 bits, including all that is drawn over the scene; but where the
   * stage `tone` makes the picture, the linear colour before it.
   */
  vtkSetMacro(HDR, bool);
  vtkGetMacro(HDR, bool);
  vtkBooleanMacro(HDR, bool);
  ///@}

  ///@{
  /**
   * Cameras that take the place of the renderer's camera one after the other. The output then has
   * one slice for each, (columns, rows, views), and no field data; its layers equal those of as
   * many sources without views, bit for bit. Views of layers that depend on the surfaces alone
   * (depth, range, normal, geometric_normal, position, albedo, actor, block, cell, arrays) are
   * drawn together, in one frame, unless observers of the renderer's or its window's StartEvent
   * want to see each. None (default): the renderer's camera.
   */
  void AddView(vtkCamera* camera);
  void RemoveAllViews();
  int GetNumberOfViews() { return static_cast<int>(this->Views.size()); }
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Captures the views without an output: calls `take` with the number of each view and an image of
   * its layers, which may be kept; more than once if a view has to be drawn again. Without views,
   * that of the renderer's camera is number 0. Calls come while views are drawn: they must neither
   * change the scene nor throw. False, after an error, if a view cannot be drawn; GetErrorCode() is
   * then NO_SUCH_LAYER if that is the reason.
   */
  bool CaptureEach(const std::function<void(std::size_t, vtkImageData*)>& take);
#endif

  /**
   * The value of GetErrorCode() if a frame was drawn, but no drawn object has a requested layer,
   * although no stage failed (vtkRelievoStage::GetReasonCode).
   */
  enum
  {
    NO_SUCH_LAYER = vtkErrorCode::UserError
  };

  /** Always newer than before, because the scene may change without notice. */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Adds to an image the parts that do not come from the G-buffer, for a picture that has been
   * drawn: the layer `color`, from the window's pixels, and the field data. For layers that were
   * read by vtkRelievoPass::ReadLayers.
   */
  static void AddColor(vtkRenderer* renderer, vtkImageData* image);
  static void AddCamera(
    vtkRenderer* renderer, vtkImageData* image, vtkRelievoPass* frame = nullptr);
  ///@}

  /**
   * Corrects the alpha of an image's layer `color` where VTK blends translucent surfaces with a
   * wrong one (VTK before 9.3, without depth peeling). This draws the frame once more, without
   * changing the window. False, after an error, if it cannot be drawn.
   */
  static bool AmendAlpha(vtkRenderer* renderer, vtkImageData* image);

protected:
  vtkRelievoLayerSource();
  ~vtkRelievoLayerSource() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoLayerSource(const vtkRelievoLayerSource&) = delete;
  void operator=(const vtkRelievoLayerSource&) = delete;

  bool Capture(vtkImageData* image);
#ifndef __VTK_WRAP__
  bool Attached(const std::function<bool()>& capture);
  bool DrawEach(const std::function<bool(std::size_t, vtkImageData*)>& take);
#endif
  bool PutViews(vtkImageData* image);
  bool IsAloneInFrame(vtkRelievoPass* pass);
  bool Draw(vtkRelievoPass* pass, bool color);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<std::string> Layers;
  std::vector<vtkSmartPointer<vtkCamera>> Views;
  bool HDR = false;
};

#endif
