// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPass
 * @brief The frame: wraps any render pass and runs the stages that the outputs asked for reach.
 *
 * A decorator: the delegate draws the picture exactly as without Relievo; the stages add layers
 * (depth, normals, ids ...) and effects. Nothing that nobody asked for is rendered, stored or
 * looked up. The frame report says what ran, why, and what it cost.
 *
 * Layers: depth, range, normal, geometric_normal, position, albedo, actor, block, cell, shadow_N
 * (of the renderer's light N), and any point or cell array by name (`point:NAME` or `cell:NAME` to
 * name one that shares a layer's name).
 */
#ifndef vtkRelievoPass_h
#define vtkRelievoPass_h

#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h" // for the delegate and the G-buffer

#include <memory> // for the internals
#include <string> // for the report
#include <vector> // for the stages

class vtkImageData;
class vtkRelievoGBufferPass;
class vtkRelievoShadowPass;
class vtkRelievoStage;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoPass : public vtkRenderPass
{
public:
  static vtkRelievoPass* New();
  vtkTypeMacro(vtkRelievoPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Puts a vtkRelievoPass around whatever pass the renderer has, and takes it away again, giving
   * the renderer's own pass back. Attach on an attached renderer returns the pass that is there.
   * Detach returns false, without an error, if none is attached.
   */
  static vtkRelievoPass* Attach(vtkRenderer* renderer);
  static bool Detach(vtkRenderer* renderer);
  ///@}

  ///@{
  /** The pass that draws the picture. Default nullptr: the renderer's own steps, without a pass. */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /** The stage that makes the layers: its formats and spaces are set there. */
  vtkRelievoGBufferPass* GetGBuffer();

  ///@{
  /** Whether shadows are seen in the picture. Default off. */
  void SetShadows(bool on);
  bool GetShadows();
  vtkBooleanMacro(Shadows, bool);
  ///@}

  /** The stage that makes the shadows: size, filter, and what casts and receives are set there. */
  vtkRelievoShadowPass* GetShadowPass();

  ///@{
  /** More stages, run in the order of their addition. The G-buffer is always there, as stage 0. */
  void AddStage(vtkRelievoStage* stage);
  void RemoveStage(vtkRelievoStage* stage);
  int GetNumberOfStages();
  vtkRelievoStage* GetStage(int i);
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
  /**
   * The layer shown as the picture, or nullptr (default) for the picture itself. Scalars are shown
   * through a colour map over DisplayRange, vectors as 0.5 v + 0.5, ids as distinct colours.
   */
  vtkSetStringMacro(DisplayLayer);
  vtkGetStringMacro(DisplayLayer);
  ///@}

  ///@{
  /**
   * Values shown as the first and the last colour, for scalar layers. Default (0, 0): from the
   * near to the far plane for depth and range, the finite extremes for arrays.
   */
  vtkSetVector2Macro(DisplayRange, double);
  vtkGetVector2Macro(DisplayRange, double);
  ///@}

  ///@{
  /**
   * Shows scalar layers as grey (or raw values in a float framebuffer), not in colours. Default
   * off.
   */
  vtkSetMacro(DisplayGrey, bool);
  vtkGetMacro(DisplayGrey, bool);
  vtkBooleanMacro(DisplayGrey, bool);
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
   * What the last frames did, as JSON: for every stage its name, whether it ran, the reason in
   * words, GPU milliseconds (of the newest frame whose timers have arrived; null before), bytes
   * held, draw calls; and the totals; and how the numbers of primitives came about that cell ids
   * need (vtkRelievoGBufferPass::GetPrimitiveIds; null where they were not needed).
   */
  std::string GetFrameReport();

  /** Bytes of GPU memory that the frame's stages hold. */
  vtkIdType GetBytesHeld();

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoPass();
  ~vtkRelievoPass() override;

  char* DisplayLayer = nullptr;
  double DisplayRange[2] = { 0.0, 0.0 };
  bool DisplayGrey = false;
  bool LayersOnly = false;

private:
  vtkRelievoPass(const vtkRelievoPass&) = delete;
  void operator=(const vtkRelievoPass&) = delete;

  void RenderDelegate(const vtkRenderState* s, const std::vector<vtkRelievoStage*>& needed);

  void Report(const vtkRenderState* s, const std::vector<vtkRelievoStage*>& needed);

  void ReleaseStages(vtkWindow* window);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
