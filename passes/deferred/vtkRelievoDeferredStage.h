// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDeferredStage
 * @brief Shades opaque surfaces once for each pixel, after they are drawn, instead of once for each
 * fragment that is drawn.
 *
 * VTK's shaders then write what a surface is made of (depth, normal, colour; its highlights or
 * metal only if some visible surface has them; the visibility of each light where some cast
 * shadows), and leave the renderer's lights out; this stage adds them. The picture is VTK's own to
 * within 1 of 255 levels for Phong, Gouraud and flat shading, 2 for PBR, as long as the light that
 * reaches a surface is at most twice what shows its full colour.
 *
 * VTK lights what cannot be deferred, and the frame report says what and why: surfaces with shader
 * code of their own, with relief or environments (vtkRelievoMaterial), PBR with image-based
 * lighting, clear coats, anisotropy, edge tints, an index of refraction other than 1.5 or textures
 * other than albedo and normals, points and lines drawn as spheres and tubes. Unlit surfaces,
 * translucent ones, volumes and texts are drawn by VTK as ever, against the same depth. Nothing is
 * deferred where the layers cannot be written while VTK draws (vtkRelievoLayersStage): in a
 * multisampled window, say; or where light comes through coloured surfaces
 * (vtkRelievoShadowStage::ColoredShadows).
 *
 * It pays where many fragments are drawn over each other, or many lights shine (docs/charts).
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
  /** Draw calls of the last frame whose light was deferred, and that VTK lit by itself. */
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
