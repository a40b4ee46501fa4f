// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoBlendStage
 * @brief The stage that keeps translucent surfaces and volumes apart until opaque ones are lit.
 *
 * Where another stage changes the linear colour of opaque surfaces (lamps, fog), VTK draws what is
 * translucent over nothing instead of over the colour: sorted, by its weighted average, or by depth
 * peeling, as without Relievo. That is the layer `blend`: premultiplied, in linear light, half
 * floats. The stage composites it, blend + (1 - a) color, after those stages, and before stages
 * that change the colour as a whole: in slot COMPOSITE, with order -1. Where nothing before
 * changes the colour, VTK blends as without Relievo, and the stage is idle.
 *
 * Layers are composited in linear light, VTK blends values for display: the same pane is a little
 * brighter over something dark.
 */
#ifndef vtkRelievoBlendStage_h
#define vtkRelievoBlendStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the internals

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoBlendStage : public vtkRelievoStage
{
public:
  static vtkRelievoBlendStage* New();
  vtkTypeMacro(vtkRelievoBlendStage, vtkRelievoStage);

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoBlendStage();
  ~vtkRelievoBlendStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

private:
  vtkRelievoBlendStage(const vtkRelievoBlendStage&) = delete;
  void operator=(const vtkRelievoBlendStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
