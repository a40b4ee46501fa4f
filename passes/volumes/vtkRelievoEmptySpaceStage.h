// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEmptySpaceStage
 * @brief The stage that lets VTK's rays through volumes skip transparent parts.
 *
 * The picture is VTK's own, bit for bit: samples in blocks of voxels that the opacity function
 * makes transparent are left out, and all others keep their places. Blocks are found on the
 * processor, when the data change, and tested when the opacity function changes.
 *
 * This applies to images of one component, composited by a function of the value, with gradient
 * opacity, cropping, clipping planes, binary masks and shadows. Other volumes are drawn in full,
 * and the stage's reason says why.
 */
#ifndef vtkRelievoEmptySpaceStage_h
#define vtkRelievoEmptySpaceStage_h

#include "vtkRelievoStage.h"
#include "vtkRelievoVolumesModule.h" // for the export macro

#include <memory> // for the internals

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoEmptySpaceStage : public vtkRelievoStage
{
public:
  static vtkRelievoEmptySpaceStage* New();
  vtkTypeMacro(vtkRelievoEmptySpaceStage, vtkRelievoStage);

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

#ifndef __VTK_WRAP__
  /** `skipped_volumes`, number of volumes; `empty_share`, of their blocks that are transparent. */
  std::map<std::string, vtkVariant> GetFacts() override;
#endif

protected:
  vtkRelievoEmptySpaceStage();
  ~vtkRelievoEmptySpaceStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;

private:
  vtkRelievoEmptySpaceStage(const vtkRelievoEmptySpaceStage&) = delete;
  void operator=(const vtkRelievoEmptySpaceStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
