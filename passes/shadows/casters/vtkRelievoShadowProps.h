// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The casters and receivers of shadows in a renderer, and whether the casters have changed since
// the previous frame.
#ifndef vtkRelievoShadowProps_h
#define vtkRelievoShadowProps_h

#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoPlacedVolume.h"
#include "vtkRelievoPointGroups.h"
#include "vtkRelievoShadowRegion.h"
#include "vtkRelievoSplicedKeys.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

class vtkActor;
class vtkMatrix4x4;
class vtkOpenGLRenderPass;
class vtkPolyData;
class vtkProp;
class vtkRelievoCasterDraw;
class vtkRelievoDepthRaster;
class vtkRenderer;
class vtkVolume;
struct vtkRelievoPlacedMesh;
struct vtkRelievoFrameProp;
struct vtkRelievoShadowView;
struct vtkRelievoSurface;

class vtkRelievoShadowProps
{
public:
  // The user's choice for a prop; casting: -1 opaque geometry only, 0 never, 1 always.
  struct Choice
  {
    vtkWeakPointer<vtkProp> Prop;
    int Casts = -1;
    bool Receives = true;
  };
  Choice& GetChoice(vtkProp* prop);

  // Collects casters and receivers: all visible props of the renderer, also outside the view.
  void Collect(vtkRenderer* renderer, const std::vector<vtkRelievoFrameProp>& drawnProps);

  // Whether translucent props without a user's choice cast where rays trace them, and let part of
  // the light pass; never into maps.
  void SetAttenuates(bool attenuates) { this->Attenuates = attenuates; }

  // Whether a translucent prop casts where rays trace it.
  bool HasTranslucentCasters() const { return this->TranslucentCasters; }

  // The state of the casters in maps, for comparison.
  const std::vector<std::uint64_t>& GetState() const { return this->State; }

  // The state of the casters in maps, and of which casters are excluded from them: with
  // `withoutFollowed`, those taken by Follow.
  std::vector<std::uint64_t> GetState(bool withoutFollowed) const;

  // The state of all casters, visible props and receivers, for comparison.
  const std::vector<std::uint64_t>& GetSceneState() const { return this->SceneState; }

  // Whether drawing alone may change the state, so that it must be collected again afterwards.
  bool ChangesByDrawing() const { return this->Unsteady; }

  // Bounds of the casters in maps, or of those left by Follow.
  std::vector<vtkRelievoBox> GetCasterBoxes(bool withoutFollowed) const;
  const std::vector<vtkRelievoBox>& GetReceiverBoxes() const { return this->ReceiverBoxes; }
  const std::vector<vtkRelievoBox>& GetAllBoxes() const { return this->AllBoxes; }
  bool Receives(vtkProp* part) const;

  // Casters that rays can trace triangle by triangle.
  std::vector<vtkRelievoPlacedMesh> Follow();
  // Visible opaque glyphs that are drawn from both sides, as faces only and without an offset, at
  // known places, from sources whose points VTK does not shift.
  std::vector<vtkRelievoPlacedMesh> GetSeenGlyphs();
  // Triangles of a mesh that Follow left because they are too many; 0: there is none.
  vtkIdType GetTooManyTriangles() const { return this->TooManyTriangles; }

  // Props with volumes that are lit, and receive.
  const std::vector<vtkProp*>& GetVolumeReceivers() const { return this->VolumeReceivers; }

  // For the frame's report: the lit volumes that cannot receive, with reasons, or "".
  const std::string& GetVolumesWithout() const { return this->VolumesWithout; }

  // Volumes that cast.
  const std::vector<vtkRelievoPlacedVolume>& GetVolumeCasters() const
  {
    return this->VolumeCasters;
  }

  // All casters and visible surfaces that rays can trace, and the boxes of the others. Without
  // `attenuates`, translucent casters block all light.
  std::vector<vtkRelievoSurface> CollectSurfaces(
    bool attenuates, std::vector<vtkRelievoBox>& others) const;

  void AddPass(vtkOpenGLRenderPass* pass);
  void RemovePass(vtkOpenGLRenderPass* pass);

  // Draws the plain meshes and many spheres among the casters by the processor, in place of
  // RenderCasters. Call BeginRaster before the first view of a map. Returns the number of
  // meshes and clouds of spheres, which count as draw calls.
  void BeginRaster()
  {
    this->Rastered.clear();
    this->Inexact.clear();
  }
  bool HasRastered() const { return !this->Rastered.empty(); }
  int RasterizeCasters(vtkRenderer* renderer, const vtkRelievoShadowView& view, const int region[4],
    vtkRelievoCasterDraw& plainDraw, bool withoutFollowed, vtkRelievoDepthRaster& raster);

  // Draws the depth of casters in the view, or of those left by Follow: plain meshes from their
  // buffers, other props by themselves, without those drawn by RasterizeCasters if so chosen.
  // Adds the draw calls for plain meshes to `draws`; returns whether there was a caster to draw.
  bool RenderCasters(vtkRenderer* renderer, const vtkRelievoShadowView& view,
    vtkRelievoCasterDraw& plainDraw, bool withoutFollowed, bool withoutRastered, int& draws);

  // Discards data about glyphs, which are computed again when needed.
  void ForgetGlyphs() { this->Glyphs = vtkRelievoGlyphPlaces(); }
  void ForgetPointGroups() { this->PointGroups.Clear(); }
  vtkIdType GetPointGroupBytes() const { return this->PointGroups.GetBytes(); }

  // Draws the depth of the visible opaque geometry in the same way.
  int RenderSurfaces(
    vtkRenderer* renderer, const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw);

  // The visible ones among all props.
  const std::vector<vtkProp*>& GetSeen() const { return this->Seen; }

  // All actors that draw these props and the others.
  const std::set<vtkProp*>& GetParts() const { return this->Parts; }

  // Whether culling changes the visible sides of visible surfaces: casting does not depend on it.
  const std::vector<bool>& GetCulling() const { return this->Culling; }

  // Whether a surface has highlights.
  bool HasHighlights() const { return this->Highlights; }

  // Whether a visible surface casts no shadow.
  bool HasMereReceivers() const { return this->MereReceivers; }

private:
  static bool HasExactFloats(
    vtkPolyData* points, vtkActor* actor, const vtkRelievoShadowView& view, const int region[4]);
  static int RenderPlain(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
    const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw);
  void Render(vtkProp* prop, bool translucent, vtkRenderer* renderer);
  void AddState(vtkActor* actor);
  void AddDouble(double value); // appends to Part
  void AddVolumes(const vtkRelievoFrameProp& visible, const Choice& choice);
  void AddVolume(const vtkRelievoFrameProp& visible, const Choice& choice, vtkVolume* volume,
    vtkMatrix4x4* matrix);

  struct Caster
  {
    vtkProp* Prop;
    bool Translucent; // translucent geometry casts in maps
    bool Attenuates;  // translucent geometry casts for rays
    bool InMaps;      // casts in maps, not only for rays
  };
  void RenderAny(const Caster& caster, vtkRenderer* renderer); // by VTK
  // How a prop casts.
  Caster GetCaster(vtkProp* prop, const Choice& choice) const;
  bool IsInMaps(const Caster& caster, bool withoutFollowed) const;
  std::vector<Choice> Choices;
  std::vector<vtkProp*> Spliced;
  std::vector<vtkProp*> Seen; // of Spliced
  std::set<vtkProp*> Mixed;   // of Spliced: assemblies in which only the meshes cast
  bool MereReceivers = false;
  bool Highlights = false;
  bool Attenuates = false;
  bool TranslucentCasters = false;
  std::vector<Caster> Casters;
  std::vector<vtkRelievoBox> CasterBoxes; // one per entry of Casters
  std::set<vtkProp*> Followed;            // of Casters
  std::set<vtkProp*> Rastered;            // of Casters, in the map that is being drawn
  std::set<vtkProp*> Inexact;     // of Casters: points that OpenGL draws, for a view of this map
  vtkIdType TooManyTriangles = 0; // of a mesh left for its triangles
  std::vector<vtkRelievoBox> ReceiverBoxes;
  std::vector<vtkRelievoBox> AllBoxes; // of receivers, whether chosen or not
  std::string VolumesWithout;
  std::vector<vtkRelievoPlacedVolume> VolumeCasters;
  std::vector<vtkProp*> VolumeReceivers;
  std::set<vtkProp*> Parts;        // props that draw themselves
  std::set<vtkProp*> NotReceiving; // of Parts
  vtkRelievoSplicedKeys Keys;
  vtkRelievoPointGroups PointGroups;
  mutable vtkRelievoGlyphPlaces Glyphs; // cached between frames
  std::vector<std::uint64_t> State;
  std::vector<std::uint64_t> SceneState;
  std::vector<std::uint64_t> Part; // of both states, during collection
  std::vector<bool> Culling;
  bool Unsteady = false;
};

#endif
