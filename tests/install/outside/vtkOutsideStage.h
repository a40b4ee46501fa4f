// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOutsideStage
 * @brief A stage of another project: the linear colour times Factor, where something is seen.
 */
#ifndef vtkOutsideStage_h
#define vtkOutsideStage_h

#include <vtkRelievoScreenQuad.h>
#include <vtkRelievoSplicedKeys.h>
#include <vtkRelievoStage.h>

class vtkOutsideStage : public vtkRelievoStage
{
public:
  static vtkOutsideStage* New();
  vtkTypeMacro(vtkOutsideStage, vtkRelievoStage);

  vtkSetClampMacro(Factor, double, 0.0, 10.0);
  vtkGetMacro(Factor, double);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkOutsideStage() = default;
  ~vtkOutsideStage() override = default;

  void Describe(vtkRelievoStageDescription& description) override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;

  double Factor = 1.0;

private:
  vtkOutsideStage(const vtkOutsideStage&) = delete;
  void operator=(const vtkOutsideStage&) = delete;

  vtkRelievoScreenQuad Quad;
  vtkRelievoSplicedKeys Spliced; // through which VTK's shaders ask this pass for changes
  int NumberOfMeshes = 0;
};

#endif
