// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts and what receives shadows in a renderer, and whether what casts has changed since the
// frame before.
#ifndef vtkRelievoShadowProps_h
#define vtkRelievoShadowProps_h

#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoShadowRegion.h"
#include "vtkRelievoSplicedKeys.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <set>
#include <vector>

class vtkActor;
class vtkOpenGLRenderPass;
class vtkProp;
class vtkRelievoCasterDraw;
class vtkRenderer;
struct vtkRelievoPlacedMesh;
struct vtkRelievoFrameProp;
struct vtkRelievoShadowView;
struct vtkRelievoSurface;

class vtkRelievoShadowProps
{
public:
  // What was chosen for a prop; casting: -1 opaque geometry only, 0 never, 1 always.
  struct Choice
  {
    vtkWeakPointer<vtkProp> Prop;
    int Casts = -1;
    bool Receives = true;
  };
  Choice& GetChoice(vtkProp* prop);

  // Casters and receivers are all visible props of the renderer, also outside the view.
  void Collect(vtkRenderer* renderer, const std::vector<vtkRelievoFrameProp>& drawnProps);

  // What is translucent and was not chosen to cast or not casts where rays follow it, and so lets
  // part of the light pass; never into maps.
  void SetAttenuates(bool attenuates) { this->Attenuates = attenuates; }

  // Whether something translucent casts where rays follow it.
  bool HasTranslucentCasters() const { return this->TranslucentCasters; }

  // The state of what casts into maps, for comparison.
  const std::vector<std::uint64_t>& GetState() const { return this->State; }

  // The state of what casts into maps, and which of it is left out of them: if `withoutFollowed`,
  // what Follow has taken.
  std::vector<std::uint64_t> GetState(bool withoutFollowed) const;

  // The state of everything that casts or is seen, and of what receives, for comparison.
  const std::vector<std::uint64_t>& GetSceneState() const { return this->SceneState; }

  // Whether drawing alone may change the state: to be collected again after it.
  bool ChangesByDrawing() const { return this->Unsteady; }

  // Of what casts into maps; or of what of it Follow has left.
  std::vector<vtkRelievoBox> GetCasterBoxes(bool withoutFollowed) const;
  const std::vector<vtkRelievoBox>& GetReceiverBoxes() const { return this->ReceiverBoxes; }
  const std::vector<vtkRelievoBox>& GetAllBoxes() const { return this->AllBoxes; }
  bool Receives(vtkProp* part) const;

  // What casts and can be followed triangle by triangle.
  std::vector<vtkRelievoPlacedMesh> Follow();
  // Of a mesh that Follow has left for them; 0: there is none.
  vtkIdType GetTooManyTriangles() const { return this->TooManyTriangles; }

  // Everything that casts or is seen and can be followed, and the boxes of what cannot. Without
  // `attenuates`, what is translucent and casts lets no light pass.
  std::vector<vtkRelievoSurface> CollectSurfaces(
    bool attenuates, std::vector<vtkRelievoBox>& others) const;

  void AddPass(vtkOpenGLRenderPass* pass);
  void RemovePass(vtkOpenGLRenderPass* pass);

  // Draws the depth of what may cast into the view, plain meshes from their buffers, the rest as
  // it draws itself; or of what of it Follow has left. Returns the draw calls of the first.
  int RenderCasters(vtkRenderer* renderer, const vtkRelievoShadowView& view,
    vtkRelievoCasterDraw& plainDraw, bool withoutFollowed);

  // What is known of glyphs is calculated again when it is needed.
  void ForgetGlyphs() { this->Glyphs = vtkRelievoGlyphPlaces(); }

  // Draws the depth of the opaque geometry that is seen, likewise.
  int RenderSurfaces(
    vtkRenderer* renderer, const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw);

  // Of all props those that are seen.
  const std::vector<vtkProp*>& GetSeen() const { return this->Seen; }

  // All actors that draw these and the props that are not.
  const std::set<vtkProp*>& GetParts() const { return this->Parts; }

  // Which sides are seen of what is seen: casting does not depend on it.
  const std::vector<bool>& GetCulling() const { return this->Culling; }

  // Whether something is seen that casts no shadow.
  bool HasMereReceivers() const { return this->MereReceivers; }

private:
  static int RenderPlain(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
    const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw);
  void Render(vtkProp* prop, bool translucent, vtkRenderer* renderer);
  void AddState(vtkActor* actor);
  void AddDouble(double value); // to Part

  struct Caster
  {
    vtkProp* Prop;
    bool Translucent; // draws its translucent geometry as well
    bool Attenuates;  // the same where rays follow it
    bool InMaps;      // not only there
  };
  // What a prop casts as.
  Caster GetCaster(vtkProp* prop, const Choice& choice) const;
  bool IsInMaps(const Caster& caster, bool withoutFollowed) const;
  std::vector<Choice> Choices;
  std::vector<vtkProp*> Spliced;
  std::vector<vtkProp*> Seen; // of Spliced
  std::set<vtkProp*> Mixed;   // of Spliced: assemblies of which only the meshes cast
  bool MereReceivers = false;
  bool Attenuates = false;
  bool TranslucentCasters = false;
  std::vector<Caster> Casters;
  std::vector<vtkRelievoBox> CasterBoxes; // of Casters, one each
  std::set<vtkProp*> Followed;            // of Casters
  vtkIdType TooManyTriangles = 0;         // of a mesh that is not followed for them
  std::vector<vtkRelievoBox> ReceiverBoxes;
  std::vector<vtkRelievoBox> AllBoxes; // of what was chosen to receive and what was not
  std::set<vtkProp*> Parts;            // that draw themselves
  std::set<vtkProp*> NotReceiving;     // of Parts
  vtkRelievoSplicedKeys Keys;
  mutable vtkRelievoGlyphPlaces Glyphs; // what is known of them from before
  std::vector<std::uint64_t> State;
  std::vector<std::uint64_t> SceneState;
  std::vector<std::uint64_t> Part; // of both, while it is made
  std::vector<bool> Culling;
  bool Unsteady = false;
};

#endif
