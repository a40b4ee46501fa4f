// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLightDepthStage
 * @brief The stage that shows a light's shadow maps: the layer `light_depth`.
 *
 * The layer is the map as the light sees it, as large as the picture has room for: float, the
 * distance along the map's axis in world units, from the light, or from the map's near plane where
 * rays are parallel; +infinity where nothing casts, and beside the map. A light with several maps
 * has them side by side, three in a row. It runs only where the layer is requested.
 *
 * Shadows need not be seen in the picture. Maps that are unevenly spaced
 * (vtkRelievoShadowStage::METHOD_WARPED) are shown as they are stored; exact shadows
 * (METHOD_EXACT) have none, but for casters that they cannot follow.
 */
#ifndef vtkRelievoLightDepthStage_h
#define vtkRelievoLightDepthStage_h

#include "vtkRelievoShadowsModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <memory> // for the internals

class VTKRELIEVOSHADOWS_EXPORT vtkRelievoLightDepthStage : public vtkRelievoStage
{
public:
  static vtkRelievoLightDepthStage* New();
  vtkTypeMacro(vtkRelievoLightDepthStage, vtkRelievoStage);

  ///@{
  /**
   * Which light: its place in vtkRenderer::GetLights(), from 0; -1 (default) for the first that
   * casts.
   */
  vtkSetClampMacro(Light, int, -1, 999);
  vtkGetMacro(Light, int);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoLightDepthStage();
  ~vtkRelievoLightDepthStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Execute(vtkRelievoFrameContext& context) override;
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

private:
  vtkRelievoLightDepthStage(const vtkRelievoLightDepthStage&) = delete;
  void operator=(const vtkRelievoLightDepthStage&) = delete;

  int Light = -1;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
