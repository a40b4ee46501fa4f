// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVolumesStage
 * @brief The stage that makes the layers of volumes: depth, position, value, normal, opacity, id.
 *
 * A volume has no surface; a rule says which place on each pixel's ray stands for it:
 * - FIRST: the first sample with an opacity above 0.
 * - OPACITY (default): where the accumulated opacity reaches a threshold. A sample stands for the
 *   step before it, with constant extinction.
 * - STRONGEST: the sample that contributes most to the pixel.
 * Volumes drawn as maximum (minimum) intensity have the place of the first greatest (least) value,
 * whatever the rule. Of several volumes, the one with the nearest place supplies the pixel; the
 * rule is applied to each volume by itself.
 *
 * The places are found in VTK's own march of vtkOpenGLGPUVolumeRayCastMapper, also inside of
 * vtkSmartVolumeMapper and vtkMultiBlockVolumeMapper, with the mapper's step of full quality,
 * without jitter: it follows transfer functions, cropping, clipping planes and masks. The ray ends
 * at the visible surface. When layers are read, the place is refined in double by the same march
 * (vtkRelievoVolumeMarch). Stages read the layer `volume_depth` as the GPU has found it. Rejected,
 * with one error: other mappers and vtkMultiVolume, blend modes other than composite, maximum and
 * minimum, and, except for FIRST, data drawn in several blocks.
 */
#ifndef vtkRelievoVolumesStage_h
#define vtkRelievoVolumesStage_h

#include "vtkRelievoStage.h"
#include "vtkRelievoVolumesModule.h" // for the export macro

#include <memory> // for the internals

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumesStage : public vtkRelievoStage
{
public:
  static vtkRelievoVolumesStage* New();
  vtkTypeMacro(vtkRelievoVolumesStage, vtkRelievoStage);

  enum Rules
  {
    FIRST = 0,
    OPACITY = 1,
    STRONGEST = 2
  };

  ///@{
  /** The place that stands for a volume: FIRST, OPACITY (default) or STRONGEST. */
  vtkSetClampMacro(Rule, int, FIRST, STRONGEST);
  vtkGetMacro(Rule, int);
  void SetRuleToFirst() { this->SetRule(FIRST); }
  void SetRuleToOpacity() { this->SetRule(OPACITY); }
  void SetRuleToStrongest() { this->SetRule(STRONGEST); }
  ///@}

  ///@{
  /**
   * The accumulated opacity of the rule OPACITY, 0.001 to 0.99: VTK ends rays at 254/255. Default
   * 0.5.
   */
  vtkSetClampMacro(Opacity, double, 0.001, 0.99);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Whether volumes count as surfaces: `depth`, `range` and `position`, when they are read, are
   * those of the nearer of surface and volume, and data sets have volumes as objects. Default off.
   */
  vtkSetMacro(Solid, bool);
  vtkGetMacro(Solid, bool);
  vtkBooleanMacro(Solid, bool);
  ///@}

  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

#ifndef __VTK_WRAP__
  /**
   * Reads layers of the last frame: see vtkRelievoStage::ReadLayers. The image's field data gets
   * the rule as the text `volumeRule`: "first", "opacity=0.5", "strongest"; with Solid, and if
   * `depth`, `range` or `position` was read, the text `depthOf`: "surfaces and volumes".
   */
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;
#endif

protected:
  vtkRelievoVolumesStage();
  ~vtkRelievoVolumesStage() override;

  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;

  int Rule = OPACITY;
  double Opacity = 0.5;
  bool Solid = false;

private:
  std::string FindNearest(vtkRelievoFrameContext& context);
  std::string Open(const std::string& layer);

  vtkRelievoVolumesStage(const vtkRelievoVolumesStage&) = delete;
  void operator=(const vtkRelievoVolumesStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
