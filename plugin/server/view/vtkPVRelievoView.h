// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoView
 * @brief Relievo's settings and frame for one of ParaView's render views, on one process.
 *
 * Sets a vtkRelievoPass as the view's render pass while any part of Relievo is on, and removes it
 * when all are off: then the view is ParaView's own. A pass set by another feature of ParaView (ray
 * tracing, value images) stays, and Relievo waits.
 *
 * Every setting is a property of the view's proxy (view.xml), so that state files, Python traces
 * and undo include it. A value outside its range is clamped, with a warning.
 */
#ifndef vtkPVRelievoView_h
#define vtkPVRelievoView_h

#include "vtkObject.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

#include <memory> // for the internals
#include <string> // for names

class vtkPVRelievoEnvironment;
class vtkPVRelievoSelection;
class vtkPVRelievoSun;
class vtkImageData;
class vtkLight;
class vtkMultiProcessController;
class vtkPVView;
class vtkRelievoPass;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoView : public vtkObject
{
public:
  static vtkPVRelievoView* New();
  vtkTypeMacro(vtkPVRelievoView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The view to work in: a vtkPVRenderView. Set once, when the view's proxy is made. */
  void SetView(vtkPVView* view);

  ///@{
  /** Shadows in the picture. Default off. */
  void SetShadows(bool on);
  bool GetShadows();
  ///@}

  enum LightKitCasting
  {
    KIT_CASTS_NOTHING = 0,
    KIT_CASTS_WITHOUT_SUN = 1, // the key light, while the sun is off
    KIT_CASTS_KEY_LIGHT = 2,
    KIT_CASTS_ALL = 3
  };

  ///@{
  /** Which lights of the view's light kit cast. Default: its key light, while the sun is off. */
  void SetLightKitCasts(int casts);
  vtkGetMacro(LightKitCasts, int);
  ///@}

  ///@{
  /**
   * A light from a fixed direction in the world, by azimuth and elevation or by date, time and
   * place on Earth (see vtkPVRelievoSun). By date, it gives no light while it is below the horizon.
   * Default off.
   */
  void SetSun(bool on);
  void SetSunValue(const char* parameter, double value);
  void SetSunValue(const char* parameter, double red, double green, double blue);
  ///@}

  /** Azimuth and elevation of the sun in degrees, for either kind of placement. */
  double* GetSunAngles() VTK_SIZEHINT(2);

  /** The name of a light in reports and layers: the light's own name in ParaView. */
  void SetLightName(vtkLight* light, const char* name);

  /** Layers of the view's lights that can cast, from the last picture; separated by commas. */
  const char* GetShadowLayers();

  ///@{
  /**
   * An image of the light from all directions, mirrored by materials of the view's surfaces
   * (vtkPVRelievoMaterial); empty (default): none. Integers count as sRGB, floats as linear light.
   * Read when it is first mirrored or shown, on each process that draws.
   */
  void SetEnvironment(const char* file);
  ///@}

  /**
   * A value of the view's vtkRelievoEnvironment by its name, in the numbers of vtkRelievoParameter.
   * By default gamma_correct is on, and z is up.
   */
  void SetEnvironmentValue(const char* parameter, double value);

  ///@{
  /** Markers around the points of the selection, by vtkRelievoMarkers. Default off. */
  void SetMarkSelection(bool on);
  void SetMarkSelectionValue(const char* parameter, double value);
  void SetMarkSelectionValue(const char* parameter, double first, double second, double third);
  ///@}

  /** Whether the environment is shown behind everything. Default off. */
  void SetSkybox(bool on);

  /** The layer that vtkRelievoPass displays; "None": the picture itself. */
  void SetDisplayLayer(const char* name);

  /**
   * Whether its legend is in the picture, if a single row of colours explains all its values;
   * scalar bars of the data are then hidden. Default on.
   */
  void SetDisplayLegend(bool on);

  ///@{
  /**
   * A stage of the frame by its name, and its parameters as "stage:parameter", in the numbers of
   * vtkRelievoParameter (a choice by its index, a flag as 0 or 1). A refused value leaves the old
   * one, with a warning. The XML of these properties, including those of shadows and of the
   * displayed layer, is generated from the stages.
   */
  void SetStageOn(const char* stage, bool on);
  void SetStageValue(const char* parameter, double value);
  void SetStageValue(const char* parameter, double first, double second);
  void SetStageValue(const char* parameter, double first, double second, double third);
  void SetStageText(const char* parameter, const char* text);
  ///@}

  ///@{
  /**
   * Layers made by the view's pictures until all requests for them are released; read them with
   * GetFrame()->ReadLayers() after a picture. The last release frees the G-buffer.
   */
  void RequestLayer(const std::string& name);
  void ReleaseLayer(const std::string& name);
  ///@}

  /**
   * Reads the displayed layer of the last picture drawn by this process into an image, with the
   * depth if the layer is a light's; false and an empty image if it drew none. The window's OpenGL
   * context must be current.
   */
  bool ReadShownLayer(const char* name, vtkImageData* image);

  /** Whether the frame draws the view's pictures: it is in use, and no other pass is. */
  bool IsInPlace();

  /** The frame report of the last picture drawn by this process, as JSON; empty before. */
  const char* GetFrameReport();

  /** Number of samples missing from the last frame (vtkRelievoFramePass). */
  int GetSamplesLeft();

  /** Number of pictures that this process has drawn with Relievo on. */
  vtkGetMacro(NumberOfFrames, int);

  /** The frame, also while it is not in use. */
  vtkRelievoPass* GetFrame();

  /** The view's sun. */
  vtkPVRelievoSun& GetSunlight();

  /** The markers of the selection in the view. */
  vtkPVRelievoSelection& GetSelection();

  /** The view's environment. */
  vtkPVRelievoEnvironment& GetEnvironment();

  /** The object for a view, or nullptr. */
  static vtkPVRelievoView* Find(vtkPVView* view);

protected:
  vtkPVRelievoView();
  ~vtkPVRelievoView() override;

  int LightKitCasts = KIT_CASTS_WITHOUT_SUN;
  double SunAngles[2] = { 0.0, 0.0 };
  int NumberOfFrames = 0;

private:
  vtkPVRelievoView(const vtkPVRelievoView&) = delete;
  void operator=(const vtkPVRelievoView&) = delete;

  bool IsAnythingOn();
  bool IsAnyStageOn();
  void Prepare();
  void KeepLayersSharp();
  void PlacePass();
  void ChooseCasters();
  void ChooseProcesses();
  void GivePoints(vtkPVView* view, vtkMultiProcessController* controller);
  void Finish();
  void EndAnnotations();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
