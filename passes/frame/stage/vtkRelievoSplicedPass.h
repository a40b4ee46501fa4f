// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSplicedPass
 * @brief Puts text of its own into the shaders of VTK's mappers while it is among a prop's keys.
 *
 * VTK's mappers call a pass twice while they build a shader: before they replace their tags, when
 * the places of its text are marked (MarkShaders), and afterwards, when the marks are filled
 * (SpliceShaders). What VTK then could not compile is tried first, and taken back: the mapper draws
 * as it would without the pass, and the reason is said once.
 */
#ifndef vtkRelievoSplicedPass_h
#define vtkRelievoSplicedPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkTimeStamp.h"          // for when shaders are built anew

#include <functional> // for what fills
#include <set>        // for what was reported
#include <string>     // for shaders

#ifndef __VTK_WRAP__
#include "vtkRelievoTrialSplice.h" // for what is spliced
#endif

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoSplicedPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkRelievoSplicedPass, vtkOpenGLRenderPass);

#ifndef __VTK_WRAP__
  ///@{
  /** Called by VTK's mappers. */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) final;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) final;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}
#endif

  /** Frees what is held of a window; VTK's own method ends the program if there is none. */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoSplicedPass();
  ~vtkRelievoSplicedPass() override;

#ifndef __VTK_WRAP__
  /** Whether shaders that are built now get the pass's text. */
  virtual bool IsSplicing() const
  {
    return false;
  }

  /** Marks the places of the pass's text, before VTK replaces its own tags. */
  virtual void MarkShaders(const vtkRelievoShaderTexts&) {}

  /** Fills the marks, by TrySplice, and reports what is wrong. */
  virtual void SpliceShaders(const vtkRelievoShaderTexts&, vtkOpenGLPolyDataMapper*, vtkActor*) {}

  /**
   * Fills the shaders by `fill`, which returns what is wrong. If anything is, or if they do not
   * compile then, they are as before.
   */
  static vtkRelievoTrialSplice::Outcome TrySplice(const vtkRelievoShaderTexts& shaders,
    vtkOpenGLRenderWindow* window, vtkActor* actor, const std::function<std::string()>& fill);

  /** Whether something is wrong that has not been reported yet of mappers of this class. */
  bool IsNews(vtkObject* mapper, const vtkRelievoTrialSplice::Outcome& outcome);

  /** Has all shaders with the pass's text built anew. */
  void ModifyShaders()
  {
    this->ShaderTime.Modified();
  }
  vtkMTimeType GetShaderTime() const
  {
    return this->ShaderTime.GetMTime();
  }
#endif

private:
  vtkRelievoSplicedPass(const vtkRelievoSplicedPass&) = delete;
  void operator=(const vtkRelievoSplicedPass&) = delete;

  vtkTimeStamp ShaderTime;
  bool BuiltUnspliced = false; // shaders without the text were built with this pass in their keys
  std::set<std::string> Reported;
};

#endif
