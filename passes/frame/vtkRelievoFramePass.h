// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFramePass
 * @brief The frame: wraps any render pass and runs the stages that the outputs asked for reach.
 *
 * A decorator: the delegate draws the picture as it would without the frame; stages add layers and
 * effects. The outputs are the picture, unless only layers are asked for, and the layers. The frame
 * works backwards from them: it runs the stages that write what is read, in the order of their
 * slots and of what they read and write, and no others; those release what they hold.
 *
 * The linear colour `color` exists while some stage reads it or it is asked for: the delegate then
 * draws into a float framebuffer (half floats) whose values go through the inverse of the sRGB
 * curve, and the picture is made of it through the curve. Otherwise the delegate draws where it
 * drew without the frame.
 *
 * vtkRelievoPass is a frame with Relievo's own stages.
 */
#ifndef vtkRelievoFramePass_h
#define vtkRelievoFramePass_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRenderPass.h"

#include <memory> // for the internals
#include <string> // for the report
#include <vector> // for names

class vtkImageData;
class vtkRelievoStage;

class VTKRELIEVOFRAME_EXPORT vtkRelievoFramePass : public vtkRenderPass
{
public:
  static vtkRelievoFramePass* New();
  vtkTypeMacro(vtkRelievoFramePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The pass that draws the picture. Default nullptr: the renderer's own steps, without a pass. */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * More stages. One that has the name of a registered stage takes its place. Their order does not
   * matter: the frame works out its own.
   */
  void AddStage(vtkRelievoStage* stage);
  void RemoveStage(vtkRelievoStage* stage);
  int GetNumberOfStages();
  ///@}

  ///@{
  /** A stage by its place, or by its name; nullptr if there is none. */
  vtkRelievoStage* GetStage(int i);
  vtkRelievoStage* GetStage(const std::string& name);
  ///@}

  ///@{
  /**
   * Layers to make in every frame, until released. An array that no visible dataset has is an
   * error when it is read.
   */
  void RequestLayer(const std::string& name);
  void ReleaseLayer(const std::string& name);
  void ReleaseLayers();
  bool IsLayerRequested(const std::string& name);
  ///@}

  ///@{
  /** Makes the layers only and leaves the picture alone: for captures. Default off. */
  vtkSetMacro(LayersOnly, bool);
  vtkGetMacro(LayersOnly, bool);
  vtkBooleanMacro(LayersOnly, bool);
  ///@}

  ///@{
  /**
   * Reads layers of the last frame into the image as point arrays of the layers' names; row 0 is
   * the bottom row. The image's dimensions are set if it has no points. Returns false, with an
   * error, at the first layer that the last frame did not make. Several at once are read faster
   * than one by one: they share what comes from the GPU.
   */
  bool ReadLayer(const std::string& name, vtkImageData* image);
  bool ReadLayers(const std::vector<std::string>& names, vtkImageData* image);
  ///@}

  /**
   * What the last frame did, as JSON: for the delegate and every stage its name, whether it ran,
   * the reason in words and as a code (vtkRelievoStage::GetReasonCode), GPU milliseconds (of the
   * newest frame whose timers have arrived; null before), bytes held, draw calls; and the totals.
   * OpenGL in software has no timers between commands: there times are taken in the eight frames
   * after a report was read, each command waited for.
   */
  std::string GetFrameReport();

  /** Bytes of GPU memory that the frame and its stages hold. */
  vtkIdType GetBytesHeld();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoFramePass();
  ~vtkRelievoFramePass() override;

  /** Adds one of each registered stage, switched on where its description says so. */
  void AddRegisteredStages();

  /** Gives back what the stages hold in the window. */
  void ReleaseStages(vtkWindow* window);

  bool LayersOnly = false;

private:
  vtkRelievoFramePass(const vtkRelievoFramePass&) = delete;
  void operator=(const vtkRelievoFramePass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
