// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoView
 * @brief What Relievo does in one of ParaView's render views, on one process.
 *
 * Puts a vtkRelievoPass where the view takes its render pass from, as long as anything of Relievo's
 * is on, and takes it away again when all is off: then the view is ParaView's own. A pass that
 * another feature of ParaView put there (ray tracing, value images) stays, and Relievo waits.
 *
 * Every setting is a property of the view's proxy (view.xml), so state files, Python traces and
 * undo know it. A value out of its range is brought into it, with a warning that says so.
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

  /** The view to work in: a vtkPVRenderView. Given once, when the view's proxy is made. */
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
   * A light from a fixed direction in the world, placed by azimuth and elevation or by date, time
   * and place on Earth (vtkPVRelievoSun says what each is). Placed by date, it gives no light while
   * it is below the horizon. Default off.
   */
  void SetSun(bool on);
  void SetSunBy(int placing);
  void SetSunDate(int year, int month, int day);
  void SetSunValue(const char* parameter, double value);
  void SetSunValue(const char* parameter, double red, double green, double blue);
  ///@}

  /** Azimuth and elevation of the sun in degrees, however it is placed. */
  double* GetSunAngles() VTK_SIZEHINT(2);

  /** What a light is called in reports and layers; the light's own name in ParaView. */
  void SetLightName(vtkLight* light, const char* name);

  /** The layers of the view's lights that can cast, as of the last picture; with commas. */
  const char* GetShadowLayers();

  ///@{
  /**
   * A picture of the light from all directions, which materials of the view's surfaces mirror
   * (vtkPVRelievoMaterial); empty (default): none. Integers count as sRGB, floats as linear light.
   * Read when it is first mirrored or shown, on each process that draws.
   */
  void SetEnvironment(const char* file);
  ///@}

  /**
   * A value of the view's vtkRelievoEnvironment by its name there, in the numbers of
   * vtkRelievoParameter. By default gamma_correct is on, and z is up.
   */
  void SetEnvironmentValue(const char* parameter, double value);

  ///@{
  /** Markers around the points of what is selected, as of vtkRelievoMarkers. Default off. */
  void SetMarkSelection(bool on);
  void SetMarkSelectionValue(const char* parameter, double value);
  void SetMarkSelectionValue(const char* parameter, double first, double second, double third);
  ///@}

  /** Whether the environment is shown behind everything. Default off. */
  void SetSkybox(bool on);

  ///@{
  /** The settings of vtkRelievoPass for the layer that is shown. */
  void SetDisplayLayer(const char* name);
  void SetDisplayRange(double first, double last);
  void SetDisplayColormap(int map);
  void SetDisplayReversed(bool on);
  void SetDisplayGrey(bool on);
  ///@}

  /**
   * Whether its legend is in the picture, where one row of colours tells all its values; scalar
   * bars of the data are out of it. Default on.
   */
  void SetDisplayLegend(bool on);

  ///@{
  /**
   * A stage of the frame by its name, and its parameters as "stage:parameter", in the numbers of
   * vtkRelievoParameter (a choice by its place, a flag as 0 or 1). What a stage does not take is
   * left as it was, with a warning. The XML of these properties, those of shadows among them, is
   * made from the stages.
   */
  void SetStageOn(const char* stage, bool on);
  void SetStageValue(const char* parameter, double value);
  void SetStageValue(const char* parameter, double first, double second, double third);
  void SetStageText(const char* parameter, const char* text);
  ///@}

  ///@{
  /**
   * Layers that the view's pictures make until all who asked for them have released them: what
   * GetFrame()->ReadLayers() reads after a picture. The G-buffer is freed with the last.
   */
  void RequestLayer(const std::string& name);
  void ReleaseLayer(const std::string& name);
  ///@}

  /**
   * Reads the layer that is shown into an image, of the last picture that this process drew, and
   * the depth with what a light reaches; false and an empty image if it drew none. The window's
   * OpenGL context must be current.
   */
  bool ReadShownLayer(const char* name, vtkImageData* image);

  /** Whether the view's pictures are drawn through the frame: it is in use, nothing else is. */
  bool IsInPlace();

  /** The frame report of the last picture that this process drew, as JSON; empty before. */
  const char* GetFrameReport();

  /** How many samples the last frame is short of (vtkRelievoFramePass). */
  int GetSamplesLeft();

  /** Pictures that this process has drawn with Relievo on. */
  vtkGetMacro(NumberOfFrames, int);

  /** The frame, also while it is not in use. */
  vtkRelievoPass* GetFrame();

  /** The view's sun. */
  vtkPVRelievoSun& GetSunlight();

  /** The markers of what is selected in the view. */
  vtkPVRelievoSelection& GetSelection();

  /** The view's environment. */
  vtkPVRelievoEnvironment& GetEnvironment();

  /** The object that works in a view, or nullptr. */
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
