// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoMarkersStage
 * @brief Rings, glows, discs and blob shadows on surfaces, around points of data and actors: over
 * the picture, and their cover of each pixel as the layer `marker`.
 *
 * The position of each pixel's surface comes from the layer `depth`; a marker colours the pixel by
 * its distance in the world, on any surface. Edges are filtered over the pixel. Markers overlap in
 * the order of their sets and points; shadows lie below all others.
 *
 * The picture is color (1 - a) + marker a, in linear light. Pixels without a surface have no
 * marker. Translucent surfaces already in the colour are covered as much as the opaque surface
 * behind them.
 */
#ifndef vtkRelievoMarkersStage_h
#define vtkRelievoMarkersStage_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPointStage.h"

#include <memory> // for the drawing half

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoMarkersStage : public vtkRelievoPointStage
{
public:
  static vtkRelievoMarkersStage* New();
  vtkTypeMacro(vtkRelievoMarkersStage, vtkRelievoPointStage);

  VTK_NEWINSTANCE vtkRelievoPointValues* NewPoints() override;
  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoMarkersStage();
  ~vtkRelievoMarkersStage() override;

  const char* GetFailure() const override { return "There are no markers"; }
  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

private:
  vtkRelievoMarkersStage(const vtkRelievoMarkersStage&) = delete;
  void operator=(const vtkRelievoMarkersStage&) = delete;

  std::string Draw(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
