// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLampsStage
 * @brief The stage that lights surfaces with lamps, in any number.
 *
 * For each pixel's point on an opaque surface, adds up intensity x colour x fall-off x max(0, n.l)
 * of every lamp (vtkRelievoLamps) in reach, and adds the sum, times the surface's colour, to the
 * picture in linear light. The sum is the layer `light`. Lamps shine through walls, except up to
 * eight that cast shadows (SetCasting, vtkRelievoLamps::SetCasts), by maps of the stage `shadows`.
 * Casting lamps are always drawn as quads.
 *
 * Ways to find the lamps of a pixel, with the same result:
 * - QUADS: a rectangle is drawn for each lamp, no larger than the lamp appears, at the front of its
 *   sphere; lamps behind surfaces cost nothing. Sums in floats, because half floats lose small
 *   addends.
 * - CLUSTERS: the view is cut into tiles of pixels and slices of depth, and the CPU lists the lamps
 *   of each cell (O. Olsson, M. Billeter, U. Assarsson, Clustered Deferred and Forward Shading,
 *   2012).
 * - ALL: every pixel computes every lamp; for comparisons.
 * AUTOMATIC selects quads for few lamps and clusters for many.
 */
#ifndef vtkRelievoLampsStage_h
#define vtkRelievoLampsStage_h

#include "vtkRelievoDeferredModule.h" // for the export macro
#include "vtkRelievoPointStage.h"

#include <memory> // for the internals

class VTKRELIEVODEFERRED_EXPORT vtkRelievoLampsStage : public vtkRelievoPointStage
{
public:
  static vtkRelievoLampsStage* New();
  vtkTypeMacro(vtkRelievoLampsStage, vtkRelievoPointStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Methods of finding the lamps of a pixel; see the class. */
  enum Ways
  {
    AUTOMATIC = 0,
    QUADS = 1,
    CLUSTERS = 2,
    ALL = 3
  };

  ///@{
  /** Method of finding the lamps of a pixel. Default AUTOMATIC. */
  vtkSetClampMacro(Way, int, AUTOMATIC, ALL);
  vtkGetMacro(Way, int);
  ///@}

  ///@{
  /**
   * Whether lamps light translucent surfaces: diffuse light, without highlights and shadows, in
   * VTK's own shaders. Default off.
   */
  vtkSetMacro(Translucent, bool);
  vtkGetMacro(Translucent, bool);
  vtkBooleanMacro(Translucent, bool);
  ///@}

  ///@{
  /**
   * Number of lamps that cast shadows in addition to those that always do
   * (vtkRelievoLamps::SetCasts), 0 (default) to 8 in all: the largest, by brightness times the part
   * of the picture that they may light. Their shadows fade if the next lamp is nearly as large, so
   * that no shadow appears or disappears abruptly while the camera moves.
   */
  vtkSetClampMacro(Casting, int, 0, 8);
  vtkGetMacro(Casting, int);
  ///@}

  /** The method of the last frame. */
  vtkGetMacro(WayTaken, int);

  ///@{
  /** Sums light in floats instead of half floats, if the method allows half floats. Default off. */
  vtkSetMacro(Floats, bool);
  vtkGetMacro(Floats, bool);
  vtkBooleanMacro(Floats, bool);
  ///@}

  /** Number of lamps in the last frame; GetNumberDrawn: those whose light may be in the picture. */
  vtkGetMacro(NumberOfLamps, int);

  /** Lamps of the last frame that cast shadows. */
  vtkGetMacro(NumberCasting, int);

  VTK_NEWINSTANCE vtkRelievoPointValues* NewPoints() override;
  vtkIdType GetBytesHeld() override;
  std::map<std::string, vtkVariant> GetFacts() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoLampsStage();
  ~vtkRelievoLampsStage() override;

  const char* GetFailure() const override { return "No light of lamps"; }
  void Synchronize(vtkRelievoFrameContext& context) override;
  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

  int Way = AUTOMATIC;
  int WayTaken = QUADS;
  bool Floats = false;
  bool Translucent = false;
  int NumberOfLamps = 0;
  int NumberCasting = 0;
  int Casting = 0;

private:
  vtkRelievoLampsStage(const vtkRelievoLampsStage&) = delete;
  void operator=(const vtkRelievoLampsStage&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
