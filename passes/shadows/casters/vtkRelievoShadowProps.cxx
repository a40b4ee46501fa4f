// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowProps.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoCasterRays.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoDepthRaster.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoHiddenPoints.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoPropMTime.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoPropParts.h"
#include "vtkRelievoShadowFit.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
using Wanted = vtkRelievoPropMeshes::Wanted;

bool IsPlain(vtkMapper* mapper)
{
  return std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0;
}

// The state of a mapper's geometry, without its colouring.
vtkMTimeType GetMapperTime(vtkMapper* mapper)
{
  const vtkMTimeType time = vtkRelievoPropMTime::OfInputs(mapper);
  // A plain mapper's own settings concern colour; other mappers' may be sizes, blocks,
  // orientations.
  return IsPlain(mapper) ? time : std::max(time, mapper->GetMTime());
}

// Whether all cells are polygons and strips.
bool HasFacesOnly(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (!HasFacesOnly(leaf->GetCurrentDataObject()))
      {
        return false;
      }
    }
    return true;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0;
}

// Whether the actor may draw beyond its bounds: points and lines, whose width is in pixels, glyphs
// of mappers whose bounds contain only the centres, and geometry moved by a shader.
bool IsLoose(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  bool moves = shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode();
  const bool bones = actor->IsA("vtkRelievoSkinnedActor"); // its bounds are those of its pose
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements() && !bones; ++i)
  {
    moves = moves || shaders->GetNthShaderReplacementTypeAsString(i) != "Fragment";
  }
  // The bounds are those of the mapper's present piece.
  auto* pieces = vtkPolyDataMapper::SafeDownCast(mapper);
  moves = moves || (pieces && pieces->GetNumberOfSubPieces() > 1);
  vtkProperty* property = actor->GetProperty();
  const bool faces = (IsPlain(mapper) || mapper->IsA("vtkCompositePolyDataMapper") ||
                       mapper->IsA("vtkCompositePolyDataMapper2")) &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetVertexVisibility() &&
    HasFacesOnly(mapper->GetInputDataObject(0, 0));
  return moves || !faces;
}

bool GetBox(vtkProp* prop, vtkRelievoBox& box)
{
  const double* b = prop->GetBounds();
  if (!b || !vtkMath::AreBoundsInitialized(b))
  {
    return false;
  }
  box.Min = glm::dvec3(b[0], b[2], b[4]);
  box.Max = glm::dvec3(b[1], b[3], b[5]);
  return !glm::any(glm::isnan(box.Min)) && !glm::any(glm::isnan(box.Max)) &&
    !glm::any(glm::isinf(box.Min)) && !glm::any(glm::isinf(box.Max));
}
}

//------------------------------------------------------------------------------
vtkRelievoShadowProps::Choice& vtkRelievoShadowProps::GetChoice(vtkProp* prop)
{
  this->Choices.erase(std::remove_if(this->Choices.begin(), this->Choices.end(),
                        [](const Choice& choice) { return !choice.Prop; }),
    this->Choices.end());
  for (Choice& choice : this->Choices)
  {
    if (choice.Prop == prop)
    {
      return choice;
    }
  }
  this->Choices.emplace_back();
  this->Choices.back().Prop = prop;
  return this->Choices.back();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::Collect(
  vtkRenderer* renderer, const std::vector<vtkRelievoFrameProp>& drawnProps)
{
  this->Spliced.clear();
  this->Seen.clear();
  this->Mixed.clear();
  this->MereReceivers = false;
  this->Highlights = false;
  this->TranslucentCasters = false;
  this->Casters.clear();
  this->CasterBoxes.clear();
  this->ReceiverBoxes.clear();
  this->AllBoxes.clear();
  this->VolumeCasters.clear();
  this->VolumeReceivers.clear();
  this->VolumesWithout.clear();
  this->Parts.clear();
  this->NotReceiving.clear();
  this->State.clear();
  this->SceneState.clear();
  this->Culling.clear();
  this->Unsteady = false;
  std::set<vtkProp*> drawn;
  for (const vtkRelievoFrameProp& drawnProp : drawnProps)
  {
    drawn.insert(drawnProp.Prop);
  }
  for (vtkRelievoFrameProp& visible : vtkRelievoFrameScene::FindVisible(renderer))
  {
    vtkProp* prop = visible.Prop;
    std::vector<vtkRelievoPropParts::Part>& parts = visible.Parts;
    Choice choice;
    for (const Choice& made : this->Choices)
    {
      choice = made.Prop == prop ? made : choice;
    }
    this->AddVolumes(visible, choice);
    const bool mixed = vtkRelievoPropParts::IsMixed(prop, parts);
    parts.erase(std::remove_if(parts.begin(), parts.end(),
                  [&choice](const vtkRelievoPropParts::Part& part) {
                    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
                    return !actor || (choice.Casts < 1 && vtkRelievoPropParts::IsAnnotation(actor));
                  }),
      parts.end());
    vtkRelievoBox box;
    box.Number = visible.Number;
    // Computing bounds also updates the mapper's input.
    if (parts.empty() || !GetBox(prop, box))
    {
      continue;
    }
    box.Loose = std::any_of(parts.begin(), parts.end(), [](const vtkRelievoPropParts::Part& part) {
      return IsLoose(vtkRelievoPropParts::GetMeshActor(part));
    });
    this->Spliced.push_back(prop);
    if (mixed)
    {
      this->Mixed.insert(prop);
    }
    const Caster caster = this->GetCaster(prop, choice);
    const bool casts = caster.InMaps;
    if (casts || caster.Attenuates)
    {
      this->Casters.push_back(caster);
      this->CasterBoxes.push_back(box);
    }
    if (casts)
    {
      this->State.push_back(reinterpret_cast<std::uintptr_t>(prop));
      this->State.push_back(caster.Translucent ? 1 : 0);
    }
    this->TranslucentCasters = this->TranslucentCasters ||
      (caster.Attenuates && prop->HasTranslucentPolygonalGeometry() != 0);
    this->AllBoxes.push_back(box);
    if (choice.Receives)
    {
      this->ReceiverBoxes.push_back(box);
    }
    if (drawn.count(prop))
    {
      this->Seen.push_back(prop);
      for (const vtkRelievoPropParts::Part& part : parts)
      {
        vtkProperty* property = vtkRelievoPropParts::GetMeshActor(part)->GetProperty();
        this->Culling.push_back(property->GetBackfaceCulling() != 0);
        this->Culling.push_back(property->GetFrontfaceCulling() != 0);
      }
      this->MereReceivers = this->MereReceivers || !casts;
    }
    for (const vtkRelievoPropParts::Part& part : parts)
    {
      vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
      this->Parts.insert(actor);
      if (!choice.Receives)
      {
        this->NotReceiving.insert(actor);
      }
      this->Part.clear();
      vtkMatrix4x4* matrix = part.Matrix ? part.Matrix : actor->GetMatrix();
      std::for_each(&matrix->Element[0][0], &matrix->Element[0][0] + 16,
        [this](double value) { this->AddDouble(value); });
      this->AddState(actor);
      if (casts)
      {
        this->State.insert(this->State.end(), this->Part.begin(), this->Part.end());
      }
      vtkProperty* property = actor->GetProperty();
      this->Highlights = this->Highlights || property->GetSpecular() != 0.0;
      this->Part.push_back((property->GetBackfaceCulling() ? 1 : 0) +
        (property->GetFrontfaceCulling() ? 2 : 0) + (casts ? 4 : 0) + (choice.Receives ? 8 : 0) +
        (caster.Translucent ? 16 : 0) + (caster.Attenuates ? 32 : 0));
      this->AddDouble(property->GetOpacity());
      this->SceneState.insert(this->SceneState.end(), this->Part.begin(), this->Part.end());
    }
  }
  std::vector<vtkProp*> inMaps;
  for (const Caster& caster : this->Casters)
  {
    if (caster.InMaps)
    {
      inMaps.push_back(caster.Prop);
    }
  }
  this->PointGroups.KeepOnly(inMaps);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::AddVolumes(const vtkRelievoFrameProp& visible, const Choice& choice)
{
  if (auto* levels = vtkLODProp3D::SafeDownCast(visible.Prop))
  {
    // Only one level is drawn: when VTK chooses, the last drawn one is expected again.
    const int last = levels->GetLastRenderedLODID();
    const int level =
      levels->GetAutomaticLODSelection() && last >= 0 ? last : levels->GetSelectedLODID();
    vtkAbstractMapper3D* drawn = levels->GetLODMapper(level);
    vtkNew<vtkPropCollection> volumes;
    levels->GetVolumes(volumes);
    for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
    {
      auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
      if (volume && volume->GetMapper() == drawn)
      {
        this->AddVolume(visible, choice, volume, levels->GetMatrix());
        return;
      }
    }
    return;
  }
  for (const vtkRelievoPropParts::Part& part : visible.Parts)
  {
    if (auto* volume = vtkVolume::SafeDownCast(part.Prop))
    {
      this->AddVolume(visible, choice, volume, part.Matrix);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::AddVolume(
  const vtkRelievoFrameProp& visible, const Choice& choice, vtkVolume* volume, vtkMatrix4x4* matrix)
{
  vtkRelievoBox box;
  box.Number = visible.Number;
  // Computing bounds also updates the mapper's input. A vtkMultiVolume may have no property.
  if (!volume->GetVisibility() || !volume->GetMapper() || !GetBox(visible.Prop, box) ||
    !volume->GetProperty())
  {
    return;
  }
  if (choice.Casts != 0)
  {
    this->VolumeCasters.emplace_back(volume, matrix);
  }
  if (choice.Receives)
  {
    const std::string why = volume->GetProperty()->GetShade()
      ? vtkRelievoPlacedVolume::FindWhyNotPlaced(volume)
      : "it is not shaded; switch its shading on (ShadeOn of its property)";
    if (!why.empty())
    {
      this->VolumesWithout += "; a volume receives none: " + why;
      return;
    }
    this->ReceiverBoxes.push_back(box);
    this->VolumeReceivers.push_back(visible.Prop);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowProps::Receives(vtkProp* part) const
{
  if (this->Parts.count(part))
  {
    return this->NotReceiving.count(part) == 0;
  }
  // A level of detail draws another actor with the keys of the selected one.
  return std::none_of(
    this->NotReceiving.begin(), this->NotReceiving.end(), [part](vtkProp* chosen) {
      return chosen->GetPropertyKeys() && chosen->GetPropertyKeys() == part->GetPropertyKeys();
    });
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::AddDouble(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  this->Part.push_back(bits);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::AddState(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  this->Unsteady = this->Unsteady || !IsPlain(mapper);
  this->Part.push_back(reinterpret_cast<std::uintptr_t>(actor));
  this->Part.push_back(reinterpret_cast<std::uintptr_t>(mapper));
  this->Part.push_back(reinterpret_cast<std::uintptr_t>(mapper->GetInputDataObject(0, 0)));
  this->Part.push_back(GetMapperTime(mapper));
  this->Part.push_back(actor->GetVisibility() ? 1 : 0);
  this->Part.push_back(actor->HasOpaqueGeometry() ? 1 : 0);
  vtkProperty* property = actor->GetProperty();
  this->Part.push_back(property->GetRepresentation());
  this->Part.push_back((property->GetVertexVisibility() ? 1 : 0) +
    (property->GetRenderPointsAsSpheres() ? 2 : 0) + (property->GetRenderLinesAsTubes() ? 4 : 0) +
    (property->GetEdgeVisibility() ? 8 : 0));
  // VTK's depth offsets, of the process and of the mapper.
  double factor = 0.0;
  double units = 0.0;
  mapper->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  this->Part.push_back(vtkMapper::GetResolveCoincidentTopology());
  this->AddDouble(factor);
  this->AddDouble(units);
  mapper->GetCoincidentTopologyLineOffsetParameters(factor, units);
  this->AddDouble(factor);
  this->AddDouble(units);
  mapper->GetCoincidentTopologyPointOffsetParameter(units);
  this->AddDouble(units);
  this->AddDouble(property->GetPointSize());
  this->AddDouble(property->GetLineWidth());
  // Cut-outs: discarded pixels cast no shadow.
  const double cutoff = vtkRelievoCutSurface::GetCutoff(actor->GetPropertyKeys());
  this->AddDouble(cutoff);
  if (cutoff > 0.0)
  {
    this->AddDouble(property->GetOpacity());
    this->Part.push_back(mapper->GetMTime()); // the mapper's colours include opacities
  }
  this->Part.push_back(vtkRelievoPropMTime::OfTexture(actor->GetTexture()));
  for (const auto& named : property->GetAllTextures())
  {
    this->Part.push_back(vtkRelievoPropMTime::OfTexture(named.second));
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    vtkObject* blocks = glyphs->GetBlockAttributes();
    this->Part.push_back(blocks ? blocks->GetMTime() : 0);
  }
  // Shader replacements and uniforms of a user may move vertices, by arrays that the mapper passes
  // on.
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  this->Part.push_back(
    shaders->HasVertexShaderCode() || shaders->GetNumberOfShaderReplacements() > 0
      ? mapper->GetMTime()
      : 0);
  this->Part.push_back(shaders->GetShaderMTime());
  this->Part.push_back(shaders->GetVertexCustomUniforms()->GetMTime());
  this->Part.push_back(shaders->GetGeometryCustomUniforms()->GetMTime());
  this->Part.push_back(shaders->GetFragmentCustomUniforms()->GetMTime());
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::AddPass(vtkOpenGLRenderPass* pass)
{
  for (vtkProp* prop : this->Spliced)
  {
    this->Keys.Add(prop, pass);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::RemovePass(vtkOpenGLRenderPass* pass)
{
  this->Keys.Remove(pass);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::Render(vtkProp* prop, bool translucent, vtkRenderer* renderer)
{
  if (this->Mixed.count(prop))
  {
    vtkRelievoPropParts::RenderMeshes(prop, translucent, renderer);
  }
  else if (translucent)
  {
    prop->RenderTranslucentPolygonalGeometry(renderer);
  }
  else
  {
    prop->RenderOpaqueGeometry(renderer);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowProps::RenderAny(const Caster& caster, vtkRenderer* renderer)
{
  this->Render(caster.Prop, false, renderer);
  if (caster.Translucent)
  {
    this->Render(caster.Prop, true, renderer);
  }
}

//------------------------------------------------------------------------------
// Whether the floats in OpenGL's buffers, which receive the shadows, are within a fraction of a
// texel of the points.
bool vtkRelievoShadowProps::HasExactFloats(
  vtkPolyData* points, vtkActor* actor, const vtkRelievoShadowView& view, const int region[4])
{
  const double stored = vtkRelievoPropMeshes::GetReach(actor->GetMapper(), points);
  const glm::dmat4 rows =
    glm::transpose(view.ViewToNDC * view.WorldToView * vtkRelievoToGlm(actor->GetMatrix()));
  const double across = 0.5 * std::max(region[2], region[3]) *
    std::max(glm::length(glm::dvec3(rows[0])), glm::length(glm::dvec3(rows[1]))) /
    (view.Parallel ? 1.0 : view.Near);
  return std::ldexp(stored, -24) * across < 0.1;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowProps::RasterizeCasters(vtkRenderer* renderer, const vtkRelievoShadowView& view,
  const int region[4], vtkRelievoCasterDraw& plainDraw, bool withoutFollowed,
  vtkRelievoDepthRaster& raster)
{
  int drawn = 0;
  std::set<vtkProp*> seen;
  for (std::size_t i = 0; i < this->Casters.size(); ++i)
  {
    const Caster& caster = this->Casters[i];
    if (!this->IsInMaps(caster, withoutFollowed) || !view.Sees(this->CasterBoxes[i]))
    {
      continue;
    }
    if (seen.empty())
    {
      seen.insert(this->Seen.begin(), this->Seen.end());
    }
    vtkPolyData* points = vtkRelievoHiddenPoints::GetMesh(caster.Prop);
    if (points && !HasExactFloats(points, static_cast<vtkActor*>(caster.Prop), view, region))
    {
      this->Inexact.insert(caster.Prop);
      this->Rastered.erase(caster.Prop);
      continue;
    }
    if (points)
    {
      if (seen.count(caster.Prop) > 0)
      {
        plainDraw.Build(caster.Prop, renderer); // the picture is drawn faster from buffers
      }
      auto* spheres = static_cast<vtkActor*>(caster.Prop);
      raster.Draw(this->PointGroups.Get(points), spheres->GetProperty()->GetPointSize(),
        view.ViewToNDC * view.WorldToView * vtkRelievoToGlm(spheres->GetMatrix()), region,
        view.Clamps());
      if (this->Inexact.count(caster.Prop) == 0)
      {
        this->Rastered.insert(caster.Prop);
      }
      ++drawn;
      continue;
    }
    vtkActor* actor = plainDraw.GetPlainActor(caster.Prop);
    if (!actor && seen.count(caster.Prop) > 0)
    {
      plainDraw.Build(caster.Prop, renderer);
      actor = plainDraw.GetPlainActor(caster.Prop);
    }
    // VTK fills the buffers of the others by drawing, here into a map that is replaced. So all
    // plain casters are in maps by the processor, whatever was drawn before.
    const bool isDrawn = !actor && plainDraw.LacksBuffers(caster.Prop);
    if (isDrawn)
    {
      this->RenderAny(caster, renderer);
      actor = plainDraw.GetPlainActor(caster.Prop);
    }
    if (actor)
    {
      plainDraw.Rasterize(actor, view.ViewToNDC * view.WorldToView, region, view.Clamps(), raster);
      this->Rastered.insert(caster.Prop);
      drawn += isDrawn ? 0 : 1; // VTK's drawing counts
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowProps::RenderCasters(vtkRenderer* renderer, const vtkRelievoShadowView& view,
  vtkRelievoCasterDraw& plainDraw, bool withoutFollowed, bool withoutRastered, int& draws)
{
  bool any = false;
  std::vector<vtkActor*> plain;
  for (std::size_t i = 0; i < this->Casters.size(); ++i)
  {
    const Caster& caster = this->Casters[i];
    if (!this->IsInMaps(caster, withoutFollowed) || !view.Sees(this->CasterBoxes[i]) ||
      (withoutRastered && this->Rastered.count(caster.Prop) > 0))
    {
      continue;
    }
    any = true;
    if (vtkActor* actor = plainDraw.GetPlainActor(caster.Prop))
    {
      plain.push_back(actor);
      continue;
    }
    this->RenderAny(caster, renderer);
  }
  draws += RenderPlain(renderer, plain, view.ViewToNDC * view.WorldToView, plainDraw);
  return any;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowProps::RenderSurfaces(
  vtkRenderer* renderer, const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw)
{
  std::vector<vtkActor*> plain;
  for (vtkProp* prop : this->Seen)
  {
    vtkActor* actor = plainDraw.GetPlainActor(prop);
    // Culled sides are invisible.
    const bool culls = actor &&
      (actor->GetProperty()->GetBackfaceCulling() || actor->GetProperty()->GetFrontfaceCulling());
    if (actor && !culls && actor->HasOpaqueGeometry())
    {
      plain.push_back(actor);
    }
    else
    {
      this->Render(prop, false, renderer);
    }
  }
  return RenderPlain(renderer, plain, worldToNDC, plainDraw);
}

//------------------------------------------------------------------------------
int vtkRelievoShadowProps::RenderPlain(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
  const glm::dmat4& worldToNDC, vtkRelievoCasterDraw& plainDraw)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int calls = 0;
  const bool begun = !actors.empty() && plainDraw.Begin(window, worldToNDC);
  for (vtkActor* actor : actors)
  {
    if (begun)
    {
      calls += plainDraw.Draw(actor);
    }
    else
    {
      actor->RenderOpaqueGeometry(renderer);
    }
  }
  if (begun)
  {
    plainDraw.End();
  }
  return calls;
}

//------------------------------------------------------------------------------
vtkRelievoShadowProps::Caster vtkRelievoShadowProps::GetCaster(
  vtkProp* prop, const Choice& choice) const
{
  const bool always = choice.Casts == 1;
  const bool bySight = choice.Casts == -1;
  return { prop, always, always || (bySight && this->Attenuates),
    always || (bySight && prop->HasOpaqueGeometry() != 0) };
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowProps::IsInMaps(const Caster& caster, bool withoutFollowed) const
{
  return caster.InMaps && !(withoutFollowed && this->Followed.count(caster.Prop) > 0);
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoPlacedMesh> vtkRelievoShadowProps::Follow()
{
  std::vector<vtkRelievoPlacedMesh> followed;
  this->Followed.clear();
  this->TooManyTriangles = 0;
  for (const Caster& caster : this->Casters)
  {
    const Wanted wanted = caster.Attenuates ? Wanted::Translucent : Wanted::Opaque;
    if (vtkRelievoPropMeshes::Collect(
          caster.Prop, wanted, this->Glyphs, followed, &this->TooManyTriangles))
    {
      this->Followed.insert(caster.Prop);
    }
  }
  return followed;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoPlacedMesh> vtkRelievoShadowProps::GetSeenGlyphs()
{
  std::vector<vtkRelievoPlacedMesh> glyphs;
  for (vtkProp* prop : this->Seen)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor && vtkGlyph3DMapper::SafeDownCast(actor->GetMapper()) && actor->HasOpaqueGeometry() &&
      vtkRelievoCasterDraw::DrawsOnlyFaces(actor) && !vtkRelievoCasterDraw::IsOffset(actor) &&
      !actor->GetProperty()->GetBackfaceCulling() && !actor->GetProperty()->GetFrontfaceCulling())
    {
      std::vector<vtkRelievoPlacedMesh> sources;
      vtkRelievoPropMeshes::Collect(prop, Wanted::Opaque, this->Glyphs, sources);
      // VTK draws shifted points at places rounded in another way.
      const bool asDrawn = std::none_of(sources.begin(), sources.end(),
        [](const auto& source) { return vtkRelievoPropMeshes::IsShifted(source.Mesh); });
      glyphs.insert(glyphs.end(), sources.begin(), asDrawn ? sources.end() : sources.begin());
    }
  }
  return glyphs;
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> vtkRelievoShadowProps::GetState(bool withoutFollowed) const
{
  std::vector<std::uint64_t> state = this->State;
  for (const Caster& caster : this->Casters)
  {
    if (caster.InMaps)
    {
      state.push_back(this->IsInMaps(caster, withoutFollowed) ? 1 : 0);
    }
  }
  return state;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoBox> vtkRelievoShadowProps::GetCasterBoxes(bool withoutFollowed) const
{
  std::vector<vtkRelievoBox> boxes;
  for (std::size_t i = 0; i < this->Casters.size(); ++i)
  {
    if (this->IsInMaps(this->Casters[i], withoutFollowed))
    {
      boxes.push_back(this->CasterBoxes[i]);
    }
  }
  return boxes;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoSurface> vtkRelievoShadowProps::CollectSurfaces(
  bool attenuates, std::vector<vtkRelievoBox>& others) const
{
  std::vector<vtkRelievoSurface> surfaces;
  for (std::size_t i = 0; i < this->Spliced.size(); ++i)
  {
    vtkProp* const prop = this->Spliced[i];
    Choice choice;
    for (const Choice& made : this->Choices)
    {
      choice = made.Prop == prop ? made : choice;
    }
    vtkRelievoSurface surface;
    const Caster kind = this->GetCaster(prop, choice);
    const bool translucent = attenuates ? kind.Attenuates : kind.Translucent;
    surface.Casts = kind.InMaps || translucent;
    surface.Receives = choice.Receives;
    std::vector<vtkRelievoPlacedMesh> casters;
    const Wanted wanted = translucent ? Wanted::Translucent : Wanted::Opaque;
    if (!vtkRelievoPropMeshes::Collect(prop, wanted, this->Glyphs, casters))
    {
      others.push_back(this->AllBoxes[i]); // one per entry of Spliced
    }
    for (const vtkRelievoPlacedMesh& caster : casters)
    {
      surface.Caster = caster;
      surface.Seen = caster.Opacity >= 1.0; // also outside the view, which the probe rounds to
                                            // steps
      surface.Caster.Opacity = attenuates ? caster.Opacity : 1.0;
      surfaces.push_back(surface);
    }
  }
  return surfaces;
}
