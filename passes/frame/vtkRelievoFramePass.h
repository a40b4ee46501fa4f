// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFramePass
 * @brief The frame: wraps any render pass and runs the stages needed for the requested outputs.
 *
 * A decorator: the delegate draws the unmodified picture; stages add layers and effects. The
 * outputs are the picture, unless only layers are requested, and the layers. The frame works
 * backwards from them: it runs the stages that write needed inputs, in the order of their slots and
 * of their inputs and outputs. All other stages release their resources.
 *
 * The linear colour `color` exists while a stage reads it or it is requested: the delegate then
 * draws into a framebuffer of half floats (floats on software OpenGL), whose values are decoded by
 * the inverse sRGB curve, and the picture is encoded from it by that curve. Otherwise the delegate
 * draws to the framebuffer that it would use without the frame.
 *
 * vtkRelievoPass is a frame with Relievo's own stages.
 */
#ifndef vtkRelievoFramePass_h
#define vtkRelievoFramePass_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoText.h"        // for names that are given
#include "vtkRenderPass.h"

#include <memory> // for the internals
#include <string> // for the report
#include <vector> // for names

class vtkImageData;
class vtkMultiProcessController;
class vtkRelievoStage;
class vtkRenderer;

class VTKRELIEVOFRAME_EXPORT vtkRelievoFramePass : public vtkRenderPass
{
public:
  static vtkRelievoFramePass* New();
  vtkTypeMacro(vtkRelievoFramePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Maximum number of lights that are on: with more, an error is reported and nothing is drawn.
   * VTK's shaders have code for each light, which takes long to compile and with some thousands
   * ends the program. vtkRelievoLamps supports any number.
   */
  enum Limits
  {
    MOST_LIGHTS = 1000
  };

#ifndef __VTK_WRAP__
  /** Returns an error message if too many lights are on, else an empty string. */
  static std::string CheckLights(vtkRenderer* renderer);
#endif

  ///@{
  /** The pass that draws the picture. Default nullptr: the renderer's own steps. */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Whether the delegate draws like the renderer's own steps: all props once, in the renderer's
   * viewport, as its camera sees them. Stages may then do work once per pixel. Default off.
   */
  vtkSetMacro(DelegateDrawsOwnSteps, bool);
  vtkGetMacro(DelegateDrawsOwnSteps, bool);
  vtkBooleanMacro(DelegateDrawsOwnSteps, bool);
  ///@}

  ///@{
  /**
   * Adds or removes stages. A stage with the name of a registered stage replaces it; the name of an
   * added stage is an error. The order of adding does not matter: the frame computes its own order.
   */
  void AddStage(vtkRelievoStage* stage);
  void RemoveStage(vtkRelievoStage* stage);
  int GetNumberOfStages();
  ///@}

  ///@{
  /** A stage by its index, or by its name; nullptr if there is none. */
  vtkRelievoStage* GetStage(int i);
  vtkRelievoStage* GetStage(RELIEVO_TEXT name);
  ///@}

  ///@{
  /**
   * Layers to make in every frame, until released. An array that no visible dataset has, or a layer
   * whose stage does not run, is an error when it is read.
   */
  void RequestLayer(RELIEVO_TEXT name);
  void ReleaseLayer(RELIEVO_TEXT name);
  void ReleaseLayers();
  bool IsLayerRequested(RELIEVO_TEXT name);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Layers to make only in frames whose other outputs, such as the picture, need their stages.
   * Default: none.
   */
  void SetOptionalLayers(const std::vector<std::string>& names);
  const std::vector<std::string>& GetOptionalLayers() const;

  ///@{
  /**
   * Whether stages may amend layers of others, as the stage volumes amends depth with `solid`. Off
   * for readers that need the surfaces' own layers. Default on.
   */
  void SetAmends(bool amends)
  {
    this->Amends = amends;
  }
  bool GetAmends() const
  {
    return this->Amends;
  }
  ///@}
#endif

  ///@{
  /** Makes only the layers and leaves the picture unchanged, for captures. Default off. */
  vtkSetMacro(LayersOnly, bool);
  vtkGetMacro(LayersOnly, bool);
  vtkBooleanMacro(LayersOnly, bool);
  ///@}

  ///@{
  /**
   * A stage may draw one sample in each frame, for example of a light with a size
   * (vtkRelievoShadowStage::SetSoftSamples); while nothing else changes, the frame shows the mean
   * of the samples gathered so far. GetSamplesLeft returns the number of samples that the last
   * frame lacks: render again until it is 0. WaitForSamples makes each frame gather all samples,
   * for saved pictures. Default off; pictures in tiles, and captures by vtkRelievoLayerSource,
   * always gather all.
   */
  int GetSamplesLeft();
  vtkSetMacro(WaitForSamples, bool);
  vtkGetMacro(WaitForSamples, bool);
  vtkBooleanMacro(WaitForSamples, bool);
  ///@}

  ///@{
  /**
   * Whether each frame draws only one sample, unless it waits for all: for programs that have to
   * respond in between on a slow GPU. Otherwise the second frame may draw all others at once, which
   * takes as long as a dozen frames. A picture drawn at once has more samples, and replaces one
   * drawn sample by sample when this is switched off, or when a frame waits. Default off.
   */
  vtkSetMacro(SamplesOneByOne, bool);
  vtkGetMacro(SamplesOneByOne, bool);
  vtkBooleanMacro(SamplesOneByOne, bool);
  ///@}

  ///@{
  /**
   * The processes that draw the frame together, each its own props: samples are gathered by all or
   * none, and rays of the stage `ambient` are traced through all processes' props. All of them draw
   * each frame, with equal settings. Shadows and stages of points have their own controllers.
   * Default none.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * Reads layers of the last frame into the image as point arrays of the layers' names; row 0 is
   * the bottom row. The image's dimensions are set if it has no points. Returns false, with an
   * error, at the first layer that the last frame did not make. Reading several layers at once is
   * faster: they share data from the GPU.
   */
  bool ReadLayer(RELIEVO_TEXT name, vtkImageData* image);
  bool ReadLayers(const std::vector<std::string>& names, vtkImageData* image);
  ///@}

  /**
   * Reads layers into the image, and returns an error message instead of reporting it; "" if all
   * were read.
   */
  std::string TryReadLayers(const std::vector<std::string>& names, vtkImageData* image);

  /**
   * Report on the last frame, as JSON: for the delegate and every stage its name, whether it ran,
   * the reason in words and as a code (vtkRelievoStage::GetReasonCode), GPU milliseconds (of the
   * newest frame whose timers have arrived; null before), bytes in use, draw calls, and the label,
   * its name for users; and the totals. Software OpenGL has no timers between commands, so there
   * only the eight frames after each reading of a report are timed, waiting for each command.
   */
  std::string GetFrameReport();

  /** Bytes of memory in use by the frame and its stages: the GPU's, and groups of points. */
  vtkIdType GetBytesHeld();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoFramePass();
  ~vtkRelievoFramePass() override;

  /** Adds one of each registered stage, switched on if its description says so. */
  void AddRegisteredStages();

  /** Releases the stages' resources in the window. */
  void ReleaseStages(vtkWindow* window);

  bool DelegateDrawsOwnSteps = false;
  bool LayersOnly = false;
  bool WaitForSamples = false;
  bool SamplesOneByOne = false;
  bool Amends = true;

private:
  vtkRelievoFramePass(const vtkRelievoFramePass&) = delete;
  void operator=(const vtkRelievoFramePass&) = delete;

  bool DrawSample(const vtkRenderState* s);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
