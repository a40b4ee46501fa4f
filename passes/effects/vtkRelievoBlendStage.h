// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoBlendStage
 * @brief The stage that keeps translucent surfaces and volumes apart until opaque ones are lit.
 *
 * Where another stage changes the linear colour of opaque surfaces (lamps, fog), VTK draws
 * translucent geometry over an empty buffer instead of over the colour: sorted, by its weighted
 * average, or by depth peeling, the same as without Relievo. That buffer is the layer `blend`:
 * premultiplied, in linear light, half floats. The stage composites it, blend + (1 - a) color,
 * after those stages, and before stages that change the whole colour: in slot COMPOSITE, with order
 * -1. If no earlier stage changes the colour, VTK blends without Relievo, and the stage is idle.
 *
 * Layers are composited in linear light, whereas VTK blends display values: a pane becomes slightly
 * brighter over dark surfaces.
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
