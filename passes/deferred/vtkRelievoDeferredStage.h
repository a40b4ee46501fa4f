// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDeferredStage
 * @brief Shades opaque surfaces once for each pixel, after they are drawn, instead of once for each
 * fragment that is drawn.
 *
 * VTK's shaders then write the surface's properties (depth, normal, colour; highlights or metal
 * only if some visible surface has them; the visibility of each light if some lights cast shadows)
 * without the renderer's lights, which this stage adds. The picture matches VTK's to within 1 of
 * 255 levels for Phong, Gouraud and flat shading, and 2 for PBR, as long as the light on a surface
 * is at most twice the light that shows its full colour.
 *
 * VTK lights the surfaces that cannot be deferred, which the frame report lists with reasons:
 * surfaces with their own shader code, with relief or environments (vtkRelievoMaterial), PBR with
 * image-based lighting, clear coats, anisotropy, edge tints, an index of refraction other than 1.5
 * or textures other than albedo and normals, and points and lines drawn as spheres and tubes. VTK
 * draws unlit and translucent surfaces, volumes and texts without change, against the same depth.
 * No surface is deferred if the layers cannot be written while VTK draws (vtkRelievoLayersStage),
 * for example in a multisampled window, or if light passes through coloured surfaces
 * (vtkRelievoShadowStage::ColoredShadows).
 *
 * Deferred shading pays if many fragments overlap or many lights are on (docs/charts).
 */
#ifndef vtkRelievoDeferredStage_h
#define vtkRelievoDeferredStage_h

#include "vtkRelievoDeferredModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <map>    // for facts
#include <memory> // for the internals
#include <string> // for names

class VTKRELIEVODEFERRED_EXPORT vtkRelievoDeferredStage : public vtkRelievoStage
{
public:
  static vtkRelievoDeferredStage* New();
  vtkTypeMacro(vtkRelievoDeferredStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Draw calls of the last frame whose light was deferred, and draw calls that VTK lit. */
  vtkGetMacro(NumberDeferred, int);
  vtkGetMacro(NumberLeft, int);
  ///@}

  std::map<std::string, vtkVariant> GetFacts() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoDeferredStage();
  ~vtkRelievoDeferredStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void EndOpaque(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;

private:
  vtkRelievoDeferredStage(const vtkRelievoDeferredStage&) = delete;
  void operator=(const vtkRelievoDeferredStage&) = delete;

  void AddLights(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
  int NumberDeferred = 0;
  int NumberLeft = 0;
};

#endif
