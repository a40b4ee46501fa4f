// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferInternals.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoLayerReader.h"
#include "vtkRelievoPass.h"
#include "vtkRenderState.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkRelievoGBufferPass);

//------------------------------------------------------------------------------
vtkRelievoGBufferPass::vtkRelievoGBufferPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoGBufferPass::~vtkRelievoGBufferPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::SetLayers(
  const std::vector<std::string>& layers, const std::vector<std::string>& read)
{
  this->Internal->Layers = layers;
  vtkRelievoGBufferLayout layout;
  layout.NormalFormat = this->NormalFormat;
  layout.DepthFormat = this->DepthFormat;
  layout.NormalDepth = this->NormalDepthFormat;
  for (const std::string& layer : layers)
  {
    vtkRelievoLayerReader::AddChannels(layer, layout);
  }
  // A depth that shares its texel with the normal is as it was written.
  const bool together =
    this->NormalDepthFormat != NORMAL_DEPTH_SEPARATE && layout.Normal && layout.Depth;
  const bool refines = this->RefineDepth && this->DepthFormat == DEPTH_32F && !together;
  for (const std::string& layer : read)
  {
    layout.Ids =
      layout.Ids || (refines && (layer == "depth" || layer == "range" || layer == "position"));
  }
  layout.Arrange();
  if (layout != this->Internal->Layout)
  {
    this->Internal->Layout = layout;
    this->Internal->StructureTime.Modified();
    this->Internal->Valid = false;
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::IsNeeded(const vtkRenderState*, std::string& reason)
{
  if (this->Internal->Layout.IsEmpty())
  {
    this->Internal->Valid = false;
    reason = "no output asks for a layer";
    return false;
  }
  reason = "asked for:";
  for (const std::string& layer : this->Internal->Layers)
  {
    reason += " " + layer;
  }
  if (!this->Internal->NotShared.empty())
  {
    reason += "; in a geometry pass of its own, since " + this->Internal->NotShared;
  }
  else
  {
    reason += "; written while the delegate draws its opaque geometry";
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::RenderBefore(vtkRelievoPass* frame, const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  in.Renderer = renderer;
  in.View.Take(renderer, s);
  in.Draws.Clear();
  in.Links.Prune();
  in.Valid = false;
  in.Writing = false;
  this->Shared = false;
  this->DrawCalls = 0;

  in.Props.Collect(s);
  in.PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  if (in.Layout.IdWord >= 0)
  {
    in.PrimitiveIds =
      vtkRelievoPrimitiveIds::Get(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
    if (in.PrimitiveIds == vtkRelievoPrimitiveIds::Unreliable &&
      in.Said.insert("primitives").second)
    {
      vtkErrorMacro("This OpenGL gives fragment shaders wrong numbers of primitives: cell ids are "
                    "-1, arrays are not read, and depth is as the rasteriser rounds it. Update its "
                    "driver, or choose another.");
    }
  }
  in.NotShared.clear();
  if (frame->GetLayersOnly())
  {
    in.NotShared = "only the layers are asked for, without the picture";
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
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::BeginOpaque(vtkRelievoPass*, const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  if (!in.NotShared.empty() || in.Writing)
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  const int* v = in.View.Viewport;
  in.NotShared = in.Target.Allocate(window, in.Layout, v[0] + v[2], v[1] + v[3]);
  if (in.NotShared.empty())
  {
    in.NotShared = in.Target.AttachShared(in.Layout, v);
  }
  if (!in.NotShared.empty())
  {
    return;
  }
  in.SetMode(vtkRelievoGBufferSplice::Mode{ false, false, in.PrimitiveIds });
  in.Offset[0] = v[0];
  in.Offset[1] = v[1];
  in.Draws.Clear();
  in.Writing = true;
  in.Props.AddPass(this);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::EndOpaque(vtkRelievoPass*, const vtkRenderState*)
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
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  if (in.Writing)
  {
    this->EndOpaque(frame, s);
    in.NotShared = "the delegate does not draw all of its opaque geometry in one go";
    in.Valid = this->Shared = false;
  }
  if (in.Valid || in.View.Viewport[2] <= 0 || in.View.Viewport[3] <= 0)
  {
    return;
  }
  if (in.NotShared.empty())
  {
    in.NotShared = "the delegate draws no opaque geometry of this renderer";
  }
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const vtkRelievoKeptState kept(window->GetState());
  std::string wrong =
    in.Target.Allocate(window, in.Layout, in.View.Viewport[2], in.View.Viewport[3]);
  if (wrong.empty())
  {
    wrong = in.Target.BeginOwn(in.Layout);
  }
  if (wrong.empty())
  {
    in.SetMode(vtkRelievoGBufferSplice::Mode{
      true, in.View.Far > 1e4 * in.View.Near && !in.View.Parallel, in.PrimitiveIds });
    in.Offset[0] = in.Offset[1] = 0;
    in.Draws.Clear();
    in.Writing = true;
    in.Props.AddPass(this);
    // As the picture has it: of VTK's ways to draw one, only the renderer's own removes them.
    in.Props.RenderOpaque(renderer,
      renderer->GetUseHiddenLineRemoval() && !frame->GetDelegatePass() && !s->GetFrameBuffer());
    in.Props.RemovePass(this);
    in.Writing = false;
    in.Target.EndOwn();
    in.Valid = true;
  }
  else if (in.Said.insert(wrong).second)
  {
    vtkErrorMacro("No layers: " << wrong << ".");
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
const vtkRelievoGBufferLayout& vtkRelievoGBufferPass::GetLayout()
{
  return this->Internal->Layout;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkRelievoGBufferPass::GetTexture(int attachment)
{
  return this->Internal->Valid ? this->Internal->Target.GetTexture(attachment) : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::GetOffset(int offset[2])
{
  offset[0] = this->Internal->Offset[0];
  offset[1] = this->Internal->Offset[1];
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::GetClippingRange(double range[2])
{
  range[0] = this->Internal->View.Near;
  range[1] = this->Internal->View.Far;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Target.Release(window);
  this->Internal->Draws.Clear();
  this->Internal->Valid = false;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalFormat: " << this->NormalFormat << "\n";
  os << indent << "DepthFormat: " << this->DepthFormat << "\n";
  os << indent << "NormalDepthFormat: " << this->NormalDepthFormat << "\n";
  os << indent << "NormalSpace: " << (this->NormalSpace == WORLD ? "World" : "View") << "\n";
  os << indent << "ShareGeometryPass: " << this->ShareGeometryPass << "\n";
  os << indent << "RefineDepth: " << this->RefineDepth << "\n";
  os << indent << "Shared: " << this->Shared << "\n";
}
