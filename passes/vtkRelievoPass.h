// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPass
 * @brief The frame with Relievo's own stages: layers, shadows, the layer that is shown, effects.
 *
 * A decorator (vtkRelievoFramePass): the delegate draws the picture exactly as without Relievo; the
 * stages add layers (depth, normals, ids ...) and effects. Only what is requested is rendered,
 * stored or looked up; the frame report lists the stages that ran, why, and their cost.
 *
 * Layers: those of vtkRelievoLayerCatalogue (depth, normal, position, cell ...; shadow_N of the
 * renderer's light N; color, the linear colour), and any point or cell array by name
 * (`point:NAME` or `cell:NAME` to name one that shares a layer's name).
 */
#ifndef vtkRelievoPass_h
#define vtkRelievoPass_h

#include "vtkRelievoFramePass.h"
#include "vtkRelievoPassesModule.h" // for the export macro

class vtkRelievoDisplayStage;
class vtkRelievoFogStage;
class vtkRelievoLayersStage;
class vtkRelievoMarkersStage;
class vtkRelievoShadowStage;
class vtkRelievoToneStage;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoPass : public vtkRelievoFramePass
{
public:
  static vtkRelievoPass* New();
  vtkTypeMacro(vtkRelievoPass, vtkRelievoFramePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Attach puts a vtkRelievoPass around whatever pass the renderer has; on an attached renderer it
   * returns the existing one. Detach removes it and restores the renderer's own pass; it returns
   * false, without an error, if none is attached.
   */
  static vtkRelievoPass* Attach(vtkRenderer* renderer);
  static bool Detach(vtkRenderer* renderer);
  ///@}

  /**
   * The stage that makes the layers: its formats and spaces are set there. This and the other
   * getters of stages return nullptr if a stage of another class has taken the place (AddStage).
   */
  vtkRelievoLayersStage* GetLayersStage();

  ///@{
  /** Whether the picture shows shadows. Default off. */
  void SetShadows(bool on);
  bool GetShadows();
  vtkBooleanMacro(Shadows, bool);
  ///@}

  /** The stage that makes the shadows: size, filter, and what casts and receives are set there. */
  vtkRelievoShadowStage* GetShadowStage();

  ///@{
  /**
   * Whether opaque surfaces are shaded once for each pixel, after they are drawn
   * (vtkRelievoDeferredStage). Default off.
   */
  void SetDeferred(bool on);
  bool GetDeferred();
  vtkBooleanMacro(Deferred, bool);
  ///@}

  /** The stage that maps the linear colour's highlights to the display's range. Default off. */
  vtkRelievoToneStage* GetToneStage();

  /** The stage that shows fog, once there is any: vtkRelievoFogStage::AddPoints. */
  vtkRelievoFogStage* GetFogStage();

  /** The stage that marks surfaces, once there are markers: vtkRelievoMarkersStage::AddPoints. */
  vtkRelievoMarkersStage* GetMarkersStage();

  ///@{
  /**
   * The layer shown as the picture, or nullptr (default) for the picture itself. Scalars are shown
   * through a colour map over DisplayRange, vectors as 0.5 v + 0.5, ids as distinct colours, light
   * (color, light) by the sRGB curve, from 0 to 1 or over DisplayRange.
   */
  void SetDisplayLayer(const char* name);
  const char* GetDisplayLayer();
  ///@}

  ///@{
  /**
   * Values shown as the first and the last colour, for scalar layers. Default (0, 0): from the
   * least to the greatest that is seen; see vtkRelievoDisplayStage::SetRange.
   */
  void SetDisplayRange(double first, double last);
  void SetDisplayRange(const double range[2]) { this->SetDisplayRange(range[0], range[1]); }
  double* GetDisplayRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /**
   * Shows scalar layers in grey (or as raw values in a float framebuffer) instead of colours.
   * Default off.
   */
  void SetDisplayGrey(bool on);
  bool GetDisplayGrey();
  vtkBooleanMacro(DisplayGrey, bool);
  ///@}

protected:
  vtkRelievoPass();
  ~vtkRelievoPass() override;

private:
  vtkRelievoPass(const vtkRelievoPass&) = delete;
  void operator=(const vtkRelievoPass&) = delete;

  vtkRelievoDisplayStage* GetDisplay();
};

#endif
