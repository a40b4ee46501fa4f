// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferInternals.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerReader.h"
#include "vtkRelievoSurfaces.h"
#include "vtkRelievoVTKVersions.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkRelievoGBufferPass);

//------------------------------------------------------------------------------
vtkRelievoGBufferPass::vtkRelievoGBufferPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoGBufferPass::~vtkRelievoGBufferPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::Describe(vtkRelievoStageDescription& description)
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
  // For stages that light: beside VTK's own light, and in its place.
  description.Writes = { "surface", "shading" };
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoGBufferPass::GetReadsFor(
  const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const
{
  const bool visibility = std::any_of(asked.begin(), asked.end(),
    [&context](const std::string& layer) { return context.Lights.count(layer) > 0; });
  return visibility ? std::vector<std::string>{ "visibility" } : std::vector<std::string>();
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::Prepare(vtkRelievoFrameContext& context)
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
    // Actors that share a mapper share its shaders: one may change what is right for all.
    in.Lit = lit;
    in.StructureTime.Modified();
  }
  if (RELIEVO_VTK_WIDE_LINE_NORMALS)
  {
    // After a change a mapper may still have the shaders of an actor that is hidden now.
    std::map<vtkMapper*, int> lines = vtkRelievoSurfaces::FindLineShaders(context.Scene);
    if (lines != in.LineShaders)
    {
      in.LineShaders = std::move(lines);
      in.StructureTime.Modified();
    }
    in.Alternating = in.Layout.TakesNormals() &&
      std::any_of(in.LineShaders.begin(), in.LineShaders.end(),
        [](const auto& each) { return each.second == vtkRelievoSurfaces::BothKinds; });
  }
  in.PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  if (in.Layout.IdWord >= 0)
  {
    in.PrimitiveIds = vtkRelievoPrimitiveIds::Get(context.Window);
    if (in.PrimitiveIds == vtkRelievoPrimitiveIds::Unreliable &&
      in.Said.insert("primitives").second)
    {
      vtkErrorMacro("This OpenGL gives fragment shaders wrong numbers of primitives: cell ids are "
                    "-1, arrays are not read, and depth is as the rasteriser rounds it. Update its "
                    "driver, or choose another.");
    }
  }
  in.LeftOut.clear();
  in.NotShared.clear();
  if (in.ShadingAsked && !in.Shading && context.GetAsked(this).size() == 1)
  {
    in.NotShared = in.Textures.WhyNot; // nothing else is asked for
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
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::BeginOpaque(vtkRelievoFrameContext& context)
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
  in.SetMode(vtkRelievoGBufferSplice::Mode{ false, false, in.PrimitiveIds, in.Shading });
  in.Offset[0] = v[0];
  in.Offset[1] = v[1];
  in.Draws.Clear();
  in.Writing = true;
  in.Props.AddPass(this);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::EndOpaque(vtkRelievoFrameContext& context)
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
    context.Provide("shading", &in.Textures);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Writing)
  {
    this->EndOpaque(context);
    in.NotShared = "the delegate does not draw all of its opaque geometry in one go";
    in.Valid = this->Shared = false;
    in.Stray = in.Stray || in.Shading;
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
    context.Provide("shading", &in.Textures);
    if (asked.size() == 1)
    {
      in.Target.Release(context.Window);
      this->Explain(
        "idle", "nothing but shading is asked for, and VTK lights: " + in.Textures.WhyNot);
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
  for (const std::string& layer : asked)
  {
    const bool internal = layer == "surface" || layer == "shading";
    internal ? context.Provide(layer, &in.Textures) : context.ProvideLayer(layer, &in.Textures);
    words += " " + layer;
  }
  this->Explain("ran",
    words +
      (this->Shared ? "; written while the delegate draws its opaque geometry"
                    : "; in a geometry pass of its own, since " + in.NotShared));
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::DrawOwnPass(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const vtkRelievoKeptState kept(context.Window->GetState());
  std::string wrong =
    in.Target.Allocate(context.Window, in.Layout, in.View.Viewport[2], in.View.Viewport[3]);
  if (wrong.empty())
  {
    wrong = in.Target.BeginOwn(in.Layout);
  }
  if (wrong.empty())
  {
    in.SetMode(vtkRelievoGBufferSplice::Mode{
      true, in.View.Far > 1e4 * in.View.Near && !in.View.Parallel, in.PrimitiveIds, false });
    in.Offset[0] = in.Offset[1] = 0;
    in.Draws.Clear();
    in.Writing = true;
    in.Props.AddPass(this);
    // As the picture has it: of VTK's ways to draw one, only the renderer's own removes them.
    in.Props.RenderOpaque(
      context.Renderer, context.Renderer->GetUseHiddenLineRemoval() && context.OwnSteps);
    in.Props.RemovePass(this);
    in.Writing = false;
    in.Target.EndOwn();
    in.Valid = true;
  }
  else
  {
    this->Explain("failed", wrong);
    if (in.Said.insert(wrong).second)
    {
      vtkErrorMacro("No layers: " << wrong << ".");
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferPass::ReadLayers(
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
    const std::string wrong = in.Valid && in.Renderer
      ? reader.Read(name, image)
      : "the last frame made no layers; ask for it (RequestLayer) and render before";
    if (!wrong.empty())
    {
      return "The layer '" + name + "' cannot be read: " + wrong + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferPass::GetPrimitiveIds()
{
  return this->Internal->Layout.IdWord >= 0
    ? vtkRelievoPrimitiveIds::ToString(this->Internal->PrimitiveIds)
    : "";
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoGBufferPass::GetFacts()
{
  const std::string ids = this->GetPrimitiveIds();
  return { { "primitive_ids", ids.empty() ? vtkVariant() : vtkVariant(ids) } };
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferPass::ProbePrimitiveIds(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  return vtkRelievoPrimitiveIds::ToString(vtkRelievoPrimitiveIds::Get(window));
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoGBufferPass::GetBytesHeld()
{
  return this->Internal->Target.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::GetSize(int size[2])
{
  size[0] = this->Internal->View.Viewport[2];
  size[1] = this->Internal->View.Viewport[3];
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::GetHoldsLayers()
{
  return this->Internal->Valid;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Target.Release(window);
  this->Internal->Draws.Clear();
  this->Internal->Valid = false;
  this->Internal->Stray = false;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::PrintSelf(ostream& os, vtkIndent indent)
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
