// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoStage
 * @brief One step of a frame (vtkRelievoFramePass): its inputs and outputs, parameters and work.
 *
 * A stage describes itself once (Describe). In each frame it declares its planned work (Declare,
 * which changes nothing); the frame works backwards from the requested outputs, and the needed
 * stages prepare and execute, in the order of their slots and of their inputs and outputs. A stage
 * never calls another stage: it finds others' output in the frame's context.
 *
 * Parameters are set by their own methods, or by name and words (SetParameter).
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
   * Whether a frame may run the stage; for `shadows` and `ambient`, whether the picture shows their
   * effect: their layers are made either way. Default on; in a new frame, set by the stage's
   * description.
   */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  /** The stage's name in frames, in reports and on the command line. */
  std::string GetStageName();

  ///@{
  /**
   * Parameters by name, in the order of the description. Values are words: "0.5", "on", "warped",
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
   * Sets a parameter, and returns an error message instead of reporting it; "" on success.
   */
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);

  /** Bytes of GPU memory in use by the stage. */
  virtual vtkIdType GetBytesHeld() { return 0; }

  /** Draw calls of the stage in the last frame. */
  vtkGetMacro(DrawCalls, int);

  ///@{
  /**
   * The reason why the stage ran, or did not, in the last frame: in words, and as a code for
   * programs. Codes: "ran", "off" (switched off), "idle" (no effect on the picture), "not_asked"
   * (none of its outputs is requested), "hidden" (its output is not visible), "refused" (the frame
   * could not place it), "failed", and others listed in a stage's own documentation.
   */
  std::string GetReason() { return this->Reason; }
  std::string GetReasonCode() { return this->ReasonCode; }
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Additional entries of the stage in the frame report, by name: numbers or words; an invalid
   * variant becomes null.
   */
  virtual std::map<std::string, vtkVariant> GetFacts()
  {
    return {};
  }
#endif

  /** Time of the last change of the stage's data; 0 without data. */
  virtual vtkMTimeType GetDataTime()
  {
    return 0;
  }

  /** Draws nothing: stages are run by frames. */
  void Render(const vtkRenderState* s) override;

#ifndef __VTK_WRAP__
  /** The stage's description, made once. */
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
   * Updates the stage's data, together with the processes that draw with this one: everything that
   * all of them need before any declares. Called in each frame for every stage that is switched on.
   */
  virtual void Synchronize(vtkRelievoFrameContext&) {}

  /**
   * Declares the stage's work in this frame in case it is needed. By default a copy of the
   * description. Changes nothing, and does not communicate with other processes.
   */
  virtual void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const;

  /**
   * Additional inputs for the requested outputs. Changes nothing.
   */
  virtual std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const;

  /** The layers that show the visibility of one of the renderer's lights, and the light's index. */
  virtual std::map<std::string, int> FindLights(
    const std::vector<std::string>& layers, vtkRenderer* renderer) const;

  ///@{
  /**
   * Called for a needed stage, in this order: Prepare, for all stages before any executes (it
   * returns false, after Explain, if the stage cannot run after all); Execute; Finish, for all
   * executed stages, in reverse order, at the end of the frame. BeginOpaque and EndOpaque are
   * called whenever the delegate's opaque geometry begins and ends.
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
   * Adds layers written by the stage in the last frame to the image's point data. Returns an error
   * message; "" if all were added.
   */
  virtual std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image);

  /** Sets the reason why the stage runs or does not: see GetReason. */
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
