// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoPass_h
#define vtkRelievoPass_h

#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkOpenGLRenderPass.h"

class VTKRELIEVOPASSES_EXPORT vtkRelievoPass : public vtkOpenGLRenderPass
{
public:
  static vtkRelievoPass* New();
  vtkTypeMacro(vtkRelievoPass, vtkOpenGLRenderPass);
  void Render(const vtkRenderState* s) override;
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkRelievoPass() = default;
  ~vtkRelievoPass() override = default;

private:
  vtkRelievoPass(const vtkRelievoPass&) = delete;
  void operator=(const vtkRelievoPass&) = delete;
};

#endif
