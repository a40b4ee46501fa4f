// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayersStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRelievoDepthSplice.h"
#include "vtkRelievoDrawTable.h"
#include "vtkRelievoFormatChoice.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRelievoGBufferTarget.h"
#include "vtkRelievoGBufferTextures.h"
#include "vtkRelievoGlyphDraws.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerReader.h"
#include "vtkRelievoMeshLinks.h"
#include "vtkRelievoOpaqueProps.h"
#include "vtkRelievoPrimitiveIds.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRelievoSurfaces.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRelievoViewsTarget.h"
#include "vtkRelievoWordFormats.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace
{
#define RELIEVO_SAME_CODE(name)                                                                    \
  static_assert(static_cast<int>(vtkRelievoLayersStage::name) ==                                   \
      static_cast<int>(vtkRelievoWordFormats::name),                                               \
    "differs from vtkRelievoWordFormats")
RELIEVO_SAME_CODE(NORMAL_AUTO);
RELIEVO_SAME_CODE(NORMAL_FLOAT32);
RELIEVO_SAME_CODE(NORMAL_FLOAT16);
RELIEVO_SAME_CODE(NORMAL_OCT16);
RELIEVO_SAME_CODE(NORMAL_OCT16_PRECISE);
RELIEVO_SAME_CODE(NORMAL_OCT8);
RELIEVO_SAME_CODE(NORMAL_OCT8_PRECISE);
RELIEVO_SAME_CODE(NORMAL_RGB10A2);
RELIEVO_SAME_CODE(NORMAL_RGB8);
RELIEVO_SAME_CODE(DEPTH_32F);
RELIEVO_SAME_CODE(DEPTH_16F);
RELIEVO_SAME_CODE(DEPTH_WINDOW_Z24);
RELIEVO_SAME_CODE(DEPTH_REVERSED_32F);
RELIEVO_SAME_CODE(NORMAL_DEPTH_SEPARATE);
RELIEVO_SAME_CODE(NORMAL_DEPTH_RGBA8);
RELIEVO_SAME_CODE(NORMAL_DEPTH_RGBA16F);
RELIEVO_SAME_CODE(NORMAL_DEPTH_RGBA32F);
#undef RELIEVO_SAME_CODE

// Outputs for shaders that are no layers.
bool IsForShaders(const vtkRelievoResourceName& name)
{
  return name == vtkRelievoResources::Surface || name == vtkRelievoResources::Shading ||
    name == vtkRelievoResources::DirectLight;
}
}

class vtkRelievoLayersStage::Internals
{
public:
  vtkRelievoGBufferLayout Layout;
  vtkRelievoGBufferSplice::Mode Mode;
  vtkRelievoGBufferTarget Target;
  vtkRelievoGBufferTextures Textures;
  vtkRelievoFrameCamera View;
  int Offset[2] = { 0, 0 }; // of the viewport within the textures
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkRelievoDrawTable Draws;
  vtkRelievoGlyphReach Glyphs;
  vtkRelievoMeshLinks Links; // built by the first read that needs them
  vtkRelievoOpaqueProps Props;
  vtkRelievoReportOnce Reported; // refusals, by reason and mapper's class
  std::string NotShared;         // why the delegate's geometry pass cannot be shared
  vtkRelievoPrimitiveIds::Route PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  bool Writing = false;
  bool RefinesDepth = true;              // of the last frame
  bool ShadingAsked = false;             // a later stage requests to light the surfaces
  bool Shading = false;                  // and is able to
  std::map<vtkMapper*, int> LineShaders; // vtkRelievoSurfaces::LineShaders, where VTK has several
  bool Alternating = false;              // actors that share a mapper need different shaders
  std::map<vtkMapper*, std::string> Lit; // reasons why VTK lights a mapper's surfaces
  std::map<vtkShaderProgram*, std::string> LeftOut; // reasons of this frame's programs
  // Of this frame's programs: whether each writes layers, and its source of primitive ids.
  struct Program
  {
    bool Writes;
    int PrimitiveSource;
  };
  std::map<vtkShaderProgram*, Program> Programs;
  bool DrawsWithoutLayers =
    false;                // a draw writes no layers, and its pixels cannot be told from others
  bool Valid = false;     // the textures hold the last frame's layers
  bool AllWritten = true; // each draw of DrawViews has written layers

  // Computes the layout for the stage's requested layers.
  void Arrange(vtkRelievoLayersStage& self, const vtkRelievoFrameContext& context);

  void CountLeft(vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  std::string WhyLit(vtkActor* actor) const;

  void TakeLineShaders(vtkRelievoLayersStage& self, const vtkRelievoFrameScene& scene)
  {
    if (!RELIEVO_VTK_WIDE_LINE_NORMALS)
    {
      return;
    }
    // After a change a mapper may still have the shaders of an actor that is now hidden.
    std::map<vtkMapper*, int> lines = vtkRelievoSurfaces::FindLineShaders(scene);
    if (lines != this->LineShaders)
    {
      this->LineShaders = std::move(lines);
      self.ModifyShaders();
    }
    this->Alternating = this->Layout.TakesNormals() &&
      std::any_of(this->LineShaders.begin(), this->LineShaders.end(),
        [](const auto& each) { return each.second == vtkRelievoSurfaces::BothKinds; });
  }

  void SetMode(vtkRelievoLayersStage& self, const vtkRelievoGBufferSplice::Mode& mode)
  {
    if (this->Mode != mode)
    {
      this->Mode = mode;
      self.ModifyShaders();
    }
  }
};

vtkStandardNewMacro(vtkRelievoLayersStage);

//------------------------------------------------------------------------------
vtkRelievoLayersStage::vtkRelievoLayersStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoLayersStage::~vtkRelievoLayersStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "gbuffer";
  description.Label = "Layers";
  description.Help = "Makes the layers: depth, normals, albedo, ids per pixel.";
  description.Slot = vtkRelievoStageDescription::SURFACES;
  description.OnByDefault = true;
  for (const vtkRelievoLayer& layer : vtkRelievoLayerCatalogue::GetAll())
  {
    constexpr int Elsewhere = vtkRelievoLayer::FROM_PICTURE | vtkRelievoLayer::FROM_STAGE;
    if ((layer.Source & Elsewhere) == 0 && !layer.OfLight)
    {
      description.Layers.push_back(layer.Name);
    }
  }
  description.WritesArrays = true;
  // For lighting stages: next to VTK's own light, instead of it, and how much of it is direct.
  description.Writes = { vtkRelievoResources::Surface, vtkRelievoResources::Shading,
    vtkRelievoResources::DirectLight };
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoResourceName> vtkRelievoLayersStage::GetReadsFor(
  const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const
{
  const bool visibility = std::any_of(asked.begin(), asked.end(),
    [&context](const std::string& layer) { return context.Lights.count(layer) > 0; });
  return visibility ? std::vector<vtkRelievoResourceName>{ vtkRelievoResources::Visibility }
                    : std::vector<vtkRelievoResourceName>();
}

//------------------------------------------------------------------------------
bool vtkRelievoLayersStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Arrange(*this, context);
  in.Renderer = context.Renderer;
  in.View = context.View;
  in.Draws.Clear();
  in.Links.Prune();
  in.Valid = false;
  in.Writing = false;
  this->Shared = false;
  this->DrawCalls = 0;

  in.Props.Collect(context.Scene);
  std::map<vtkMapper*, std::string> lit;
  if (in.Shading)
  {
    lit = vtkRelievoSurfaces::FindLit(context.Scene, context.Renderer, in.View.GetWinding() < 0.0);
  }
  if (lit != in.Lit)
  {
    // Actors that share a mapper share its shaders, so a change of one may affect all.
    in.Lit = lit;
    this->ModifyShaders();
  }
  in.TakeLineShaders(*this, context.Scene);
  in.PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  if (in.Layout.IdWord >= 0)
  {
    in.PrimitiveIds = vtkRelievoPrimitiveIds::Get(context.Window);
    if (in.PrimitiveIds == vtkRelievoPrimitiveIds::Unreliable && in.Reported.IsNew("primitives"))
    {
      vtkErrorMacro("This OpenGL gives fragment shaders wrong numbers of primitives: cell ids are "
                    "-1, arrays are not read, and depth is as the rasteriser rounds it. Update its "
                    "driver, or choose another.");
    }
  }
  in.LeftOut.clear();
  in.Programs.clear();
  in.NotShared.clear();
  if (in.ShadingAsked && !in.Shading && context.GetAsked(this).size() == 1)
  {
    in.NotShared = in.Textures.WhyNot; // no other layer is requested
  }
  else if (!this->ShareGeometryPass)
  {
    in.NotShared = "ShareGeometryPass is off";
  }
  else if (!in.Props.GetForeign().empty())
  {
    in.NotShared = "a " + in.Props.GetForeign() + " is drawn among the opaque geometry";
  }
  else if (in.View.Far > 1e4 * in.View.Near && !in.View.Parallel)
  {
    in.NotShared = "far / near is beyond 1e4, where window z orders fragments no more";
  }
  else if (in.Props.ShowsEdges() && !in.ShadingAsked)
  {
    in.NotShared = "the edges of faces are shown, and reach beyond them";
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::BeginOpaque(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (!in.NotShared.empty() || in.Writing)
  {
    return;
  }
  const int* v = in.View.Viewport;
  in.NotShared = in.Target.Allocate(context.Window, in.Layout, v[0] + v[2], v[1] + v[3]);
  if (in.NotShared.empty())
  {
    in.NotShared = in.Target.AttachShared(in.Layout, v);
  }
  if (!in.NotShared.empty())
  {
    return;
  }
  in.SetMode(*this, vtkRelievoGBufferSplice::Mode{ false, false, in.PrimitiveIds, in.Shading });
  in.Offset[0] = v[0];
  in.Offset[1] = v[1];
  in.Draws.Clear();
  in.Writing = true;
  in.Props.AddPass(this);
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::EndOpaque(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (!in.Writing)
  {
    return;
  }
  in.Props.RemovePass(this);
  in.Target.DetachShared();
  in.Writing = false;
  in.Valid = true;
  this->Shared = true;
  if (in.Shading)
  {
    in.Textures.Set(in.Layout, in.Target, in.Offset, this->NormalSpace == WORLD);
    context.Provide(vtkRelievoResources::Shading, &in.Textures);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Writing)
  {
    this->EndOpaque(context);
    in.NotShared = "the delegate does not draw all of its opaque geometry in one go";
    in.Valid = this->Shared = false;
    in.DrawsWithoutLayers = in.DrawsWithoutLayers || in.Shading;
  }
  const std::vector<std::string>& asked = context.GetAsked(this);
  if (!in.Valid && in.NotShared.empty())
  {
    in.NotShared = context.Picture ? "the delegate draws no opaque geometry of this renderer"
                                   : "only the layers are asked for, without the picture";
  }
  if (in.ShadingAsked && !in.Valid)
  {
    in.Textures.WhyNot = in.Textures.WhyNot.empty() ? in.NotShared : in.Textures.WhyNot;
    context.Provide(vtkRelievoResources::Shading, &in.Textures);
    if (asked.size() == 1)
    {
      in.Target.Release(context.Window);
      this->Explain("idle", "only shading is asked for, and VTK lights: " + in.Textures.WhyNot);
      return;
    }
  }
  if (!in.Valid && in.View.Viewport[2] > 0 && in.View.Viewport[3] > 0)
  {
    this->DrawOwnPass(context);
  }
  if (!in.Valid)
  {
    return;
  }
  std::string words = "asked for:";
  in.Textures.Set(in.Layout, in.Target, in.Offset, this->NormalSpace == WORLD);
  in.Textures.SetDraws(in.Draws, context.Window);
  for (const std::string& layer : asked)
  {
    const auto name = vtkRelievoResourceName::Of(layer);
    IsForShaders(name) ? context.Provide(name, &in.Textures)
                       : context.ProvideLayer(layer, &in.Textures);
    words += " " + layer;
  }
  this->Explain("ran",
    words +
      (this->Shared ? "; written while the delegate draws its opaque geometry"
                    : "; in a geometry pass of its own, since " + in.NotShared));
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::DrawOwnPass(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const vtkRelievoScopedState kept(context.Window->GetState());
  std::string error =
    in.Target.Allocate(context.Window, in.Layout, in.View.Viewport[2], in.View.Viewport[3]);
  if (error.empty())
  {
    error = in.Target.BeginOwn(in.Layout);
  }
  if (error.empty())
  {
    in.SetMode(*this,
      vtkRelievoGBufferSplice::Mode{
        true, in.View.Far > 1e4 * in.View.Near && !in.View.Parallel, in.PrimitiveIds, false });
    in.Offset[0] = in.Offset[1] = 0;
    in.Draws.Clear();
    in.Writing = true;
    in.Props.AddPass(this);
    // Removes hidden lines if the picture does: only the renderer's own steps remove them in VTK.
    in.Props.RenderOpaque(
      context.Renderer, context.Renderer->GetUseHiddenLineRemoval() && context.OwnSteps);
    in.Props.RemovePass(this);
    in.Writing = false;
    in.Target.EndOwn();
    in.Valid = true;
  }
  else
  {
    this->Explain("failed", error);
    if (in.Reported.IsNew(error))
    {
      vtkErrorMacro("No layers: " << error << ".");
    }
  }
}

//------------------------------------------------------------------------------
// Whether a view follows from the scene, its camera and the layout alone.
bool vtkRelievoLayersStage::CanRepeat(
  const vtkRelievoFrameScene& scene, vtkRenderer* renderer) const
{
  const Internals& in = *this->Internal;
  const vtkRelievoGBufferLayout& layout = in.Layout;
  const auto choosesDetail = [](const vtkRelievoFrameProp& each) {
    return each.Prop->IsA("vtkLODProp3D") || each.Prop->IsA("vtkLODActor") ||
      each.Prop->IsA("vtkQuadricLODActor");
  };
  return in.Valid && !this->Shared && in.Renderer == renderer && !layout.Surface &&
    layout.Shadows.empty() && !layout.Places && !renderer->GetUseHiddenLineRemoval() &&
    !vtkRelievoSurfaces::AreMoved(scene) &&
    std::none_of(scene.Props.begin(), scene.Props.end(), choosesDetail);
}

//------------------------------------------------------------------------------
bool vtkRelievoLayersStage::DrawViews(vtkRenderer* renderer, const std::vector<vtkCamera*>& cameras,
  const std::vector<std::string>& names,
  const std::function<void(std::size_t, vtkImageData*)>& take)
{
  Internals& in = *this->Internal;
  vtkRelievoFrameScene scene;
  scene.Props = vtkRelievoFrameScene::FindVisible(renderer);
  if (!this->CanRepeat(scene, renderer))
  {
    return false;
  }
  in.TakeLineShaders(*this, scene); // those of the last frame are of the actors in its view
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  window->MakeCurrent();
  vtkRelievoViewsTarget target(
    window, in.Layout, in.View.Viewport[2], in.View.Viewport[3], static_cast<int>(cameras.size()));
  // Each view has a table of its draws.
  constexpr std::size_t mostDraws = 1 << 16;
  const std::size_t most = std::min(static_cast<std::size_t>(target.GetNumberOfViews()),
    std::max<std::size_t>(1, mostDraws / std::max<std::size_t>(1, scene.Props.size())));
  vtkRelievoOpaqueProps all;
  all.Collect(scene);
  vtkNew<vtkRelievoDepthSplice> depth;
  for (std::size_t first = 0; first < cameras.size(); first += most)
  {
    const std::size_t count = std::min(most, cameras.size() - first);
    std::vector<vtkRelievoFrameCamera> views(count);
    std::vector<vtkRelievoDrawTable> draws(count + 1);
    draws[0] = in.Draws;  // of the view before
    bool isStale = false; // pipelines that follow the camera hold the data of the last view only
    {
      const vtkRelievoScopedState kept(window->GetState());
      if (count == 0 || !target.Begin())
      {
        return false;
      }
      depth->Begin(scene, window); // before the stage, as in a frame
      all.AddPass(this);
      in.Writing = in.AllWritten = true;
      for (std::size_t i = 0; i < count && !isStale; ++i)
      {
        renderer->SetActiveCamera(cameras[first + i]);
        views[i].Take(renderer, nullptr);
        in.View = views[i];
        in.SetMode(*this,
          vtkRelievoGBufferSplice::Mode{
            true, in.View.Far > 1e4 * in.View.Near && !in.View.Parallel, in.PrimitiveIds, false });
        vtkRelievoFrameScene seen = scene;
        seen.Cull(renderer);
        in.Props.Collect(seen);
        in.Draws.Clear();
        target.Draw(static_cast<int>(i));
        in.Props.RenderOpaque(renderer, false);
        draws[i + 1] = in.Draws;
        isStale = draws[i].IsStale();
      }
      all.RemovePass(this);
      depth->End();
      in.Writing = false;
      in.Valid = false;
      target.End();
    }
    if (std::any_of(draws.begin(), draws.end(),
          [](const vtkRelievoDrawTable& table) { return table.IsStale(); }))
    {
      return false;
    }
    const int region[4] = { 0, 0, in.View.Viewport[2], in.View.Viewport[3] };
    for (std::size_t i = 0; i < count; ++i)
    {
      target.Select(static_cast<int>(i));
      vtkRelievoLayerReader reader(in.Layout, target, region, views[i]);
      reader.SetNormalSpaceIsWorld(this->NormalSpace == WORLD);
      reader.SetRefineDepth(in.RefinesDepth);
      reader.SetDraws(&draws[i + 1], &in.Links, renderer);
      vtkNew<vtkImageData> image;
      for (const std::string& name : names)
      {
        if (!in.AllWritten || !reader.Read(name, image).empty())
        {
          return false;
        }
      }
      take(first + i, image);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayersStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  Internals& in = *this->Internal;
  const int region[4] = { in.Offset[0], in.Offset[1], in.View.Viewport[2], in.View.Viewport[3] };
  vtkRelievoLayerReader reader(in.Layout, in.Target, region, in.View);
  reader.SetNormalSpaceIsWorld(this->NormalSpace == WORLD);
  reader.SetRefineDepth(in.RefinesDepth);
  reader.SetDraws(&in.Draws, &in.Links, in.Renderer);
  for (const std::string& name : names)
  {
    const std::string error = in.Valid && in.Renderer
      ? reader.Read(name, image)
      : "the last frame made no layers; ask for it (RequestLayer) and render before";
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayersStage::GetPrimitiveIds()
{
  return this->Internal->Layout.IdWord >= 0
    ? vtkRelievoPrimitiveIds::ToString(this->Internal->PrimitiveIds)
    : "";
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoLayersStage::GetFacts()
{
  const std::string ids = this->GetPrimitiveIds();
  return { { "primitive_ids", ids.empty() ? vtkVariant() : vtkVariant(ids) } };
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayersStage::ProbePrimitiveIds(vtkOpenGLRenderWindow* window)
{
  if (!window)
  {
    vtkGenericWarningMacro("ProbePrimitiveIds was given no window; give it one with a context.");
    return {};
  }
  window->MakeCurrent();
  return vtkRelievoPrimitiveIds::ToString(vtkRelievoPrimitiveIds::Get(window));
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLayersStage::GetBytesHeld()
{
  return this->Internal->Target.GetBytes() + this->Internal->Textures.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::GetSize(int size[2])
{
  size[0] = this->Internal->View.Viewport[2];
  size[1] = this->Internal->View.Viewport[3];
}

//------------------------------------------------------------------------------
bool vtkRelievoLayersStage::GetHoldsLayers()
{
  return this->Internal->Valid;
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Target.Release(window);
  this->Internal->Textures.Release(window);
  this->Internal->Draws.Clear();
  this->Internal->Valid = false;
  this->Internal->DrawsWithoutLayers = false;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalFormat: " << this->NormalFormat << "\n";
  os << indent << "DepthFormat: " << this->DepthFormat << "\n";
  os << indent << "NormalTolerance: " << this->NormalTolerance << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "NormalDepthFormat: " << this->NormalDepthFormat << "\n";
  os << indent << "NormalSpace: " << (this->NormalSpace == WORLD ? "World" : "View") << "\n";
  os << indent << "ShareGeometryPass: " << this->ShareGeometryPass << "\n";
  os << indent << "RefineDepth: " << this->RefineDepth << "\n";
  os << indent << "Shared: " << this->Shared << "\n";
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::Internals::Arrange(
  vtkRelievoLayersStage& self, const vtkRelievoFrameContext& context)
{
  this->RefinesDepth = self.RefineDepth;
  vtkRelievoGBufferLayout layout;
  layout.Narrow = vtkRelievoIsSoftwareOpenGL();
  layout.Lights = context.Lights;
  layout.NormalFormat = self.GetNormalFormatUsed();
  layout.DepthFormat = self.GetDepthFormatUsed();
  const bool separate = self.NormalTolerance > 0.0 || self.DepthTolerance > 0.0;
  layout.NormalDepth = separate ? static_cast<int>(NORMAL_DEPTH_SEPARATE) : self.NormalDepthFormat;
  for (const std::string& layer : context.GetAsked(&self))
  {
    const auto name = vtkRelievoResourceName::Of(layer);
    if (name == vtkRelievoResources::DirectLight)
    {
      // Deferred shading adds the lights later.
      layout.DirectLight = context.IsPlanned(vtkRelievoResources::ShadowMaps) &&
        !context.IsPlanned(vtkRelievoResources::Shading);
    }
    else if (IsForShaders(name))
    {
      layout.Surface = true;
    }
    else
    {
      vtkRelievoLayerReader::AddChannels(layer, layout);
    }
  }
  // A depth that shares its texel with the normal is not refined.
  const bool together =
    layout.NormalDepth != NORMAL_DEPTH_SEPARATE && layout.Normal && layout.Depth;
  const bool refines = self.RefineDepth && layout.DepthFormat == DEPTH_32F && !together;
  for (const std::string& layer : context.ReadBack)
  {
    layout.Ids = layout.Ids ||
      (refines && vtkRelievoLayerCatalogue::Find(layer).Source == vtkRelievoLayer::FROM_DEPTH);
  }
  // Whether some pixels' positions do not follow from their depth.
  const bool placed = std::any_of(
    context.ReadBack.begin(), context.ReadBack.end(), vtkRelievoLayerReader::NeedsPlaces);
  layout.Places = placed && vtkRelievoSurfaces::AreMoved(context.Scene);
  layout.Depth = layout.Depth || layout.Places;
  layout.Ids = layout.Ids || layout.Places;
  if (layout.Surface)
  {
    const vtkRelievoSurfaces surfaces = vtkRelievoSurfaces::Find(context.Scene);
    layout.SurfaceDetail = surfaces.Detail;
    layout.SurfaceSpecular = surfaces.Specular;
    layout.SurfacePbr = surfaces.Pbr;
  }
  std::vector<int> asked; // lights whose visibility is a requested layer
  this->Textures.WhyNot.clear();
  this->Textures.Left.clear();
  this->Textures.Deferred = this->Textures.NumberOfLights = 0;
  this->ShadingAsked = context.IsAsked(&self, vtkRelievoResources::Shading);
  if (this->ShadingAsked)
  {
    this->Textures.WhyNot = this->DrawsWithoutLayers
      ? "a surface was drawn by a shader that takes no splice, or the delegate draws in several "
        "steps"
      : context.ColorsLight ? "translucent surfaces or volumes colour the light that passes them"
                            : vtkRelievoSurfaces::WhyAllLit(context.Scene, context.Window);
  }
  this->Shading = this->ShadingAsked && this->Textures.WhyNot.empty();
  if (this->Shading)
  {
    layout.Depth = layout.Normal = true;
    asked = layout.Shadows;
    if (context.IsPlanned(vtkRelievoResources::ShadowMaps))
    {
      layout.Shadows.resize(context.Renderer->GetLights()->GetNumberOfItems());
      std::iota(layout.Shadows.begin(), layout.Shadows.end(), 0);
      this->Textures.NumberOfLights = static_cast<int>(layout.Shadows.size());
    }
  }
  layout.Arrange();
  if (this->Shading && layout.GetNumberOfAttachments() > vtkRelievoGBufferLayout::MostAttachments)
  {
    this->Textures.WhyNot = "the visibility of " + std::to_string(layout.Shadows.size()) +
      " lights takes more than " + std::to_string(vtkRelievoGBufferLayout::MostAttachments) +
      " attachments";
    this->Shading = false;
    layout.Shadows = asked;
    layout.Arrange();
  }
  const bool changed = layout != this->Layout;
  this->Layout = layout;
  if (changed)
  {
    self.ModifyShaders();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoLayersStage::IsSplicing() const
{
  return this->Internal->Writing;
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::MarkShaders(const vtkRelievoShaderTexts& shaders)
{
  vtkRelievoGBufferSplice::Mark(shaders.Vertex, shaders.Geometry, shaders.Fragment);
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  Internals& in = *this->Internal;
  const auto splice = [&](vtkRelievoGBufferSplice::Mode mode) {
    mode.Deferred =
      mode.Deferred && actor->GetProperty()->GetLighting() && in.WhyLit(actor).empty();
    return TrySplice(
      shaders, static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow()), actor, [&]() {
        return vtkRelievoGBufferSplice::Fill(
          shaders.Vertex, shaders.Geometry, shaders.Fragment, mapper, actor, in.Layout, mode);
      });
  };
  vtkRelievoTrialSplice::Outcome outcome = splice(in.Mode);
  if (!outcome.Compiles && in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader)
  {
    vtkRelievoGBufferSplice::Mode without = in.Mode;
    without.PrimitiveIds = vtkRelievoPrimitiveIds::Unreliable;
    outcome = splice(without);
  }
  const std::string name = mapper->GetClassName();
  if (this->IsNews(mapper, outcome))
  {
    vtkWarningMacro("No layers of geometry drawn by " << name << ": " << outcome.Error << ".");
  }
  const bool numbered = vtkRelievoGBufferSplice::GetPrimitiveSource(mapper, actor) !=
    vtkRelievoGBufferSplice::GetPrimitiveSource(shaders.Fragment);
  if (outcome.Error.empty() && numbered && in.Layout.IdWord >= 0 &&
    in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader &&
    in.Reported.IsNew(name + "ids"))
  {
    vtkErrorMacro("No cell ids of geometry drawn by "
      << name << ": with this OpenGL they need a geometry shader, which cannot pass on all outputs "
      << "of the vertex shader. Declare one output of a simple type per line.");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoLayersStage::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Writing || !mapper || !actor)
  {
    return true;
  }
  // Draws into the depth buffer alone (hidden line removal) write no layers.
  unsigned char mask[4] = { 1, 1, 1, 1 };
  static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetBooleanv(GL_COLOR_WRITEMASK, mask);
  auto known = in.Programs.find(program);
  if (known == in.Programs.end())
  {
    const std::string fragment = program->GetFragmentShader()->GetSource();
    known = in.Programs
              .emplace(program,
                Internals::Program{ fragment.find("relievoOutput1") != std::string::npos,
                  vtkRelievoGBufferSplice::GetPrimitiveSource(fragment) })
              .first;
  }
  const bool writes = (mask[0] || mask[1] || mask[2] || mask[3]) && known->second.Writes;
  in.Target.WriteLayers(writes);
  in.AllWritten = in.AllWritten && writes;
  if (!writes)
  {
    const bool seen = mask[0] || mask[1] || mask[2] || mask[3];
    in.DrawsWithoutLayers = in.DrawsWithoutLayers || (seen && in.Mode.Deferred);
    return true;
  }
  ++this->DrawCalls;
  if (vtkRelievoIsProjective(actor->GetMatrix()) && in.Reported.IsNew("projective"))
  {
    vtkWarningMacro("An actor's matrix is projective: its last row is not 0 0 0 1. VTK lights it "
                    "at other positions than it draws it, and its depth, positions, normals and "
                    "shadows are those of the lit positions; transform its points instead, with "
                    "vtkTransformFilter.");
  }
  if (in.Layout.IdWord >= 0)
  {
    const std::uint32_t first = in.Draws.Add(actor, mapper, known->second.PrimitiveSource);
    if (in.Draws.IsLastAmbiguous() && in.Reported.IsNew("blocks"))
    {
      vtkErrorMacro("No cell and block ids of some composite data: this VTK gives primitives of "
                    "several of its blocks the same numbers where cells have normals but no "
                    "colours. Colour the cells, or compute the normals at the points.");
    }
    program->SetUniformi("relievoFirstPrimitive", static_cast<int>(first));
    if (first == vtkRelievoDrawTable::Nothing && in.Reported.IsNew("words"))
    {
      vtkErrorMacro("More primitives are drawn than 32 bits can count: the last ones have the ids "
                    "-1, no arrays, and depth with the rasteriser's rounding. Draw fewer at once.");
    }
  }
  in.Glyphs.SetUniforms(program, mapper);
  program->SetUniformi(
    "relievoFaces", actor->GetProperty()->GetRepresentation() == VTK_SURFACE ? 1 : 0);
  if (in.Layout.SurfaceWord >= 0)
  {
    vtkRelievoSurfaces::SetUniforms(program, actor);
    in.CountLeft(program, mapper, actor);
  }
  const double winding = actor->GetMatrix()->Determinant() * in.View.GetWinding();
  program->SetUniformf("relievoWinding", winding < 0.0 ? -1.0f : 1.0f);
  program->SetUniformf("relievoNear", static_cast<float>(in.View.Near));
  program->SetUniformf("relievoFar", static_cast<float>(in.View.Far));
  return true;
}

//------------------------------------------------------------------------------
// Counts the draw as deferred, or as lit by VTK for a reason.
void vtkRelievoLayersStage::Internals::CountLeft(
  vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  if (!this->Mode.Deferred || !actor->GetProperty()->GetLighting())
  {
    return; // an unlit surface
  }
  auto known = this->LeftOut.find(program);
  if (known == this->LeftOut.end())
  {
    const std::string fragment = program->GetFragmentShader()->GetSource();
    const bool out = fragment.find("#define RELIEVO_LIGHT_LEFT_OUT") != std::string::npos;
    std::string why = out ? std::string() : this->WhyLit(actor);
    why = out || !why.empty() ? why : vtkRelievoSurfaces::WhyLit(mapper, fragment);
    why = out || !why.empty() ? why : "has a shader without VTK's code for lights";
    known = this->LeftOut.emplace(program, why).first;
  }
  ++(known->second.empty() ? this->Textures.Deferred : this->Textures.Left[known->second]);
}

//------------------------------------------------------------------------------
// The reason why VTK has to light the actor, or an actor that shares its mapper's shaders.
std::string vtkRelievoLayersStage::Internals::WhyLit(vtkActor* actor) const
{
  const auto found = this->Lit.find(actor->GetMapper());
  return found != this->Lit.end() ? found->second
                                  : vtkRelievoSurfaces::WhyLit(actor, this->Renderer);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoLayersStage::GetShaderStageMTime()
{
  // If actors alternate in a mapper's shaders, each needs its own program.
  if (this->Internal->Alternating)
  {
    this->ModifyShaders();
  }
  return this->Superclass::GetShaderStageMTime();
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::SetNormalTolerance(double degrees)
{
  if (!vtkRelievoFormatChoice::IsNormalTolerance(degrees))
  {
    vtkErrorMacro("SetNormalTolerance was given "
      << degrees << "; give it 1e-5, the error of the most accurate format, to 180 degrees, or 0 "
      << "for the format that is set.");
    return;
  }
  if (this->NormalTolerance != degrees)
  {
    this->NormalTolerance = degrees;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayersStage::SetDepthTolerance(double share)
{
  if (!vtkRelievoFormatChoice::IsDepthTolerance(share))
  {
    vtkErrorMacro("SetDepthTolerance was given "
      << share << "; give it 6e-8, the error of the most accurate format, to 1, as a share of the "
      << "depth, or 0 for the format that is set.");
    return;
  }
  if (this->DepthTolerance != share)
  {
    this->DepthTolerance = share;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoLayersStage::GetNormalFormatUsed()
{
  return this->NormalTolerance > 0.0 ? vtkRelievoFormatChoice::ChooseNormal(this->NormalTolerance)
                                     : this->NormalFormat;
}

//------------------------------------------------------------------------------
int vtkRelievoLayersStage::GetDepthFormatUsed()
{
  return this->DepthTolerance > 0.0 ? vtkRelievoFormatChoice::ChooseDepth(this->DepthTolerance)
                                    : this->DepthFormat;
}
