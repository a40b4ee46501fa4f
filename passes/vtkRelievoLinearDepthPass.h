// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLinearDepthPass
 * @brief Shows depth in grey, normalised as (-z - near) / (far - near) or in world units.
 *
 * In world units the value itself is written. A float framebuffer (such as that of
 * vtkFramebufferPass) keeps it in full, and the window's 8 bits clamp it to 1; SetRange() maps a
 * range of depths to 0 to 1 instead. The background is white (1).
 */
#ifndef vtkRelievoLinearDepthPass_h
#define vtkRelievoLinearDepthPass_h

#include "vtkNew.h"                 // for the frame
#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkRenderPass.h"

class vtkRelievoPass;

class VTKRELIEVOPASSES_EXPORT vtkRelievoLinearDepthPass : public vtkRenderPass
{
public:
  static vtkRelievoLinearDepthPass* New();
  vtkTypeMacro(vtkRelievoLinearDepthPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The pass that draws the scene. Default nullptr, which means the renderer's own steps. */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Whether depths from the near to the far plane map to 0 to 1. Default on; off shows world units.
   */
  vtkSetMacro(Normalized, bool);
  vtkGetMacro(Normalized, bool);
  vtkBooleanMacro(Normalized, bool);
  ///@}

  ///@{
  /**
   * The depths, in world units, that map to 0 and 1 when Normalized is off. Default (0, 1), which
   * shows the depth itself.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoLinearDepthPass();
  ~vtkRelievoLinearDepthPass() override;

  bool Normalized = true;
  double Range[2] = { 0.0, 1.0 };

private:
  vtkRelievoLinearDepthPass(const vtkRelievoLinearDepthPass&) = delete;
  void operator=(const vtkRelievoLinearDepthPass&) = delete;

  vtkNew<vtkRelievoPass> Frame;
};

#endif
