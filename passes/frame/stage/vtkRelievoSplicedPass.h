// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSplicedPass
 * @brief Splices text into the shaders of VTK's mappers while the pass is among a prop's keys.
 *
 * VTK's mappers call a pass twice while they build a shader: before they replace their tags, to
 * mark the places of its text (MarkShaders), and afterwards, to fill the marks (SpliceShaders). The
 * result is test-compiled first: if it fails, the mapper draws without the pass, and the reason is
 * reported once.
 */
#ifndef vtkRelievoSplicedPass_h
#define vtkRelievoSplicedPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoReportOnce.h"  // for errors
#include "vtkTimeStamp.h"          // for when shaders are built anew

#include <functional> // for TrySplice
#include <string>     // for shaders

#ifndef __VTK_WRAP__
#include "vtkRelievoTrialSplice.h" // for shader texts
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

  /** Frees the window's resources; VTK's own method crashes without a window. */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoSplicedPass();
  ~vtkRelievoSplicedPass() override;

#ifndef __VTK_WRAP__
  /** Whether shaders built now get the pass's text. */
  virtual bool IsSplicing() const
  {
    return false;
  }

  /** Marks the places of the pass's text, before VTK replaces its own tags. */
  virtual void MarkShaders(const vtkRelievoShaderTexts&) {}

  /** Fills the marks by TrySplice, and reports errors. */
  virtual void SpliceShaders(const vtkRelievoShaderTexts&, vtkOpenGLPolyDataMapper*, vtkActor*) {}

  /**
   * Fills the shaders by `fill`, which returns an error message or an empty string. On an error, or
   * if the shaders do not compile, they remain unchanged.
   */
  static vtkRelievoTrialSplice::Outcome TrySplice(const vtkRelievoShaderTexts& shaders,
    vtkOpenGLRenderWindow* window, vtkActor* actor, const std::function<std::string()>& fill);

  /** Whether the outcome is an error not yet reported for this class of mapper. */
  bool IsNews(vtkObject* mapper, const vtkRelievoTrialSplice::Outcome& outcome);

  /** Triggers a rebuild of all shaders with the pass's text. */
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
  bool BuiltUnspliced = false; // the pass's keys have shaders built without the text
  vtkRelievoReportOnce Reported;
};

#endif
