// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoStage
 * @brief One step of the frame (vtkRelievoPass): what it needs, what it does, what it holds.
 *
 * The frame asks a stage whether an output asked for reaches it, orders the stages, calls them and
 * writes their line of the frame report. A stage never calls another stage: it names the layers it
 * needs and reads them from the frame's G-buffer.
 */
#ifndef vtkRelievoStage_h
#define vtkRelievoStage_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoPassesModule.h" // for the export macro

#include <string> // for reasons
#include <vector> // for layer names

class vtkRelievoPass;

class VTKRELIEVOPASSES_EXPORT vtkRelievoStage : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkRelievoStage, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether the frame may run the stage. Default on. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  /** Short name of the stage, as the frame report and the layers' owners say it. */
  virtual std::string GetStageName() = 0;

  /** Bytes of GPU memory that the stage holds now. */
  virtual vtkIdType GetBytesHeld() { return 0; }

  /** Draw calls of the stage in the last frame. */
  vtkGetMacro(DrawCalls, int);

  /** Draws nothing: stages are called by the frame. */
  void Render(const vtkRenderState* s) override;

protected:
  vtkRelievoStage() = default;
  ~vtkRelievoStage() override = default;

  friend class vtkRelievoPass;

  /**
   * Whether an output that was asked for reaches this stage in this frame; `reason` says in words
   * why or why not.
   */
  virtual bool IsNeeded(const vtkRenderState* s, std::string& reason) = 0;

  /** Layers that the stage reads in this frame, if it is needed. */
  virtual std::vector<std::string> GetNeededLayers() { return {}; }

  ///@{
  /**
   * Called for a needed stage, in this order: before the delegate draws; when the delegate's opaque
   * geometry begins and ends (only if the delegate draws some); after the delegate.
   */
  virtual void RenderBefore(vtkRelievoPass*, const vtkRenderState*) {}
  virtual void BeginOpaque(vtkRelievoPass*, const vtkRenderState*) {}
  virtual void EndOpaque(vtkRelievoPass*, const vtkRenderState*) {}
  virtual void RenderAfter(vtkRelievoPass*, const vtkRenderState*) {}
  ///@}

  bool Enabled = true;
  int DrawCalls = 0;

private:
  vtkRelievoStage(const vtkRelievoStage&) = delete;
  void operator=(const vtkRelievoStage&) = delete;
};

#endif
