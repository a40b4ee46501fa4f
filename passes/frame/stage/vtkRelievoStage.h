// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoStage
 * @brief One step of a frame (vtkRelievoFramePass): what it reads and writes, its parameters, its
 * work.
 *
 * A stage describes itself once (Describe). In each frame it says what it would do (Declare, which
 * changes nothing); the frame works backwards from what is requested, and the stages that are
 * needed prepare and execute, in the order of their slots and of what they read and write. A stage
 * never calls another stage: it finds what others wrote in the frame's context.
 *
 * Parameters are set by their own methods or by name and words (SetParameter).
 */
#ifndef vtkRelievoStage_h
#define vtkRelievoStage_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoSplicedPass.h"
#include "vtkRelievoStageDescription.h" // for the description
#include "vtkRelievoText.h"             // for names that are given
#include "vtkVariant.h"                 // for facts

#include <map>    // for lights
#include <memory> // for the description
#include <string> // for names and words
#include <vector> // for names

class vtkImageData;
class vtkRelievoFrameContext;
class vtkRenderer;
struct vtkRelievoDeclaration;

class VTKRELIEVOFRAME_EXPORT vtkRelievoStage : public vtkRelievoSplicedPass
{
public:
  vtkTypeMacro(vtkRelievoStage, vtkRelievoSplicedPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether a frame may run the stage; of `shadows` and `ambient`, whether the picture shows what
   * they do: their layers are there either way. Default on; in a new frame, as the stage says.
   */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  /** The stage's name, as in frames, reports and on the command line. */
  std::string GetStageName();

  ///@{
  /**
   * Parameters by name, as the description lists them. Values are words: "0.5", "on", "warped",
   * "1,0.5,0". Set returns false, with an error, and changes nothing if there is no such parameter
   * or the value is not allowed. Get returns "" if there is no such parameter. The default is a new
   * stage's value.
   */
  int GetNumberOfParameters() { return this->GetDescription().GetNumber(); }
  std::string GetParameterName(int i) { return this->GetDescription().GetName(i); }
  std::string GetParameterHelp(RELIEVO_TEXT name) { return this->GetDescription().GetHelp(name); }
  std::string GetParameterDefault(RELIEVO_TEXT name)
  {
    return this->GetDescription().GetDefault(name);
  }
  std::string GetParameter(RELIEVO_TEXT name) { return this->GetDescription().GetValue(name); }
  bool SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);
  ///@}

  /**
   * Sets a parameter, and returns what is wrong in words instead of reporting it; "" if the value
   * was set.
   */
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);

  /** Bytes of GPU memory that the stage holds now. */
  virtual vtkIdType GetBytesHeld() { return 0; }

  /** Draw calls of the stage in the last frame. */
  vtkGetMacro(DrawCalls, int);

  ///@{
  /**
   * Why the stage ran, or did not, in the last frame: in words, and as a code for programs. Codes:
   * "ran", "off" (switched off), "idle" (it has nothing to do for the picture), "not_asked"
   * (nothing that it writes is requested), "hidden" (what it writes is not visible), "refused" (the
   * frame could not place it), "failed", and others that a stage's own documentation lists.
   */
  std::string GetReason() { return this->Reason; }
  std::string GetReasonCode() { return this->ReasonCode; }
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Entries of the stage in the frame report beside its own line, by name: numbers, or words; an
   * invalid variant is null there.
   */
  virtual std::map<std::string, vtkVariant> GetFacts()
  {
    return {};
  }
#endif

  /** When the data that the stage works on has last changed; 0 if it works on none. */
  virtual vtkMTimeType GetDataTime()
  {
    return 0;
  }

  /** Draws nothing: frames call stages. */
  void Render(const vtkRenderState* s) override;

#ifndef __VTK_WRAP__
  /** The stage's description; made once. */
  const vtkRelievoStageDescription& GetDescription();
#endif

protected:
  vtkRelievoStage();
  ~vtkRelievoStage() override;

  friend class vtkRelievoFramePass;
  friend class vtkRelievoFrameReader;
  friend class vtkRelievoFrameRun;

  /** Fills in the description. */
  virtual void Describe(vtkRelievoStageDescription& description) = 0;

  /**
   * Brings what the stage is given up to date, together with the processes that draw with this one:
   * what all of them have to know before any of them declares. Called in each frame for a stage
   * that is switched on.
   */
  virtual void Synchronize(vtkRelievoFrameContext&) {}

  /**
   * What the stage would do in this frame if it is needed. By default, what the description says.
   * Changes nothing, and talks to no other process.
   */
  virtual void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const;

  /**
   * What the stage reads in addition, in order to write what is requested of it. Changes nothing.
   */
  virtual std::vector<std::string> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const;

  /** The layers that are the visibility of one of the renderer's lights, and which light. */
  virtual std::map<std::string, int> FindLights(
    const std::vector<std::string>& layers, vtkRenderer* renderer) const;

  ///@{
  /**
   * Called for a stage that is needed, in this order: Prepare, for all stages before any executes
   * (it returns false, after Explain, if the stage cannot run after all); Execute; Finish, for all
   * that executed, in the opposite order, when the frame is done. BeginOpaque and EndOpaque are
   * called each time that the delegate's opaque geometry begins and ends.
   */
  virtual bool Prepare(vtkRelievoFrameContext&)
  {
    return true;
  }
  virtual void Execute(vtkRelievoFrameContext&) {}
  virtual void BeginOpaque(vtkRelievoFrameContext&) {}
  virtual void EndOpaque(vtkRelievoFrameContext&) {}
  virtual void Finish(vtkRelievoFrameContext&) {}
  ///@}

  /**
   * Adds layers that the stage wrote in the last frame to the image's point data. Returns what is
   * wrong, in words: "" if all were added.
   */
  virtual std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image);

  /** Says why the stage runs or does not: see GetReason. */
  void Explain(const std::string& code, const std::string& words);

  bool Enabled = true;
  int DrawCalls = 0;

private:
  vtkRelievoStage(const vtkRelievoStage&) = delete;
  void operator=(const vtkRelievoStage&) = delete;

  std::unique_ptr<vtkRelievoStageDescription> Description;
  std::string Reason;
  std::string ReasonCode;
};

#endif
