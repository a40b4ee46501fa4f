// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLightDepthStage
 * @brief The stage that shows a light's shadow maps: the layer `light_depth`.
 *
 * The layer is the map as seen from the light, as large as fits the picture: float, the distance
 * along the map's axis in world units, from the light, or with parallel rays from the map's near
 * plane; +infinity without casters, and beside the map. A light's several maps are side by side,
 * three in a row. The stage runs only if the layer is requested.
 *
 * Shadows need not be visible in the picture. Uneven maps (vtkRelievoShadowStage::METHOD_WARPED)
 * are shown as stored; exact shadows (METHOD_EXACT) have maps only for casters that rays cannot
 * trace.
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
   * The light's index in vtkRenderer::GetLights(), from 0; -1 (default) for the first that casts.
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
