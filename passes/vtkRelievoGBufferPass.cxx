// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferPass.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoDrawTable.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRelievoGBufferTarget.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoLayerReader.h"
#include "vtkRelievoMeshLinks.h"
#include "vtkRelievoOpaqueProps.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPrimitiveIds.h"
#include "vtkRelievoShaderTrial.h"
#include "vtkRelievoView.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <set>

vtkStandardNewMacro(vtkRelievoGBufferPass);

class vtkRelievoGBufferPass::Internals
{
public:
  std::vector<std::string> Layers;
  vtkRelievoGBufferLayout Layout;
  vtkRelievoGBufferSplice::Mode Mode;
  vtkTimeStamp StructureTime; // of the layout and the mode: shaders older than it are built anew
  vtkRelievoGBufferTarget Target;
  vtkRelievoView View;
  int Offset[2] = { 0, 0 }; // of the viewport within the textures
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkRelievoDrawTable Draws;
  vtkRelievoMeshLinks Links; // built when a read needs them
  vtkRelievoOpaqueProps Props;
  std::set<std::string> Said; // refusals that have been reported, by reason and mapper's class
  std::string NotShared;      // why the delegate's geometry pass cannot be shared
  vtkRelievoPrimitiveIds::Route PrimitiveIds = vtkRelievoPrimitiveIds::AsWritten;
  bool Writing = false;
  bool Strayed = false; // shaders without layers were built with this pass in their keys
  bool Valid = false; // the textures hold the last frame's layers

  void SetMode(const vtkRelievoGBufferSplice::Mode& mode)
  {
    if (this->Mode != mode)
    {
      this->Mode = mode;
      this->StructureTime.Modified();
    }
  }
};

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
    in.PrimitiveIds = vtkRelievoPrimitiveIds::Get(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
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
bool vtkRelievoGBufferPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Internal->Writing && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    vtkRelievoGBufferSplice::Mark(vertexShader, geometryShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Writing || !mapper || !actor)
  {
    return true;
  }
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  // Returns what is wrong, in words, and leaves the shaders as they were then.
  auto fill = [&](const vtkRelievoGBufferSplice::Mode& mode, bool& compiles) {
    std::string wrong = vtkRelievoGBufferSplice::Fill(
      vertexShader, geometryShader, fragmentShader, mapper, actor, in.Layout, mode);
    compiles = true;
    if (wrong.empty())
    {
      wrong = vtkRelievoShaderTrial::Compile(
        static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow()),
        actor->GetShaderProperty(), vertexShader, geometryShader, fragmentShader);
      compiles = wrong.empty();
    }
    if (!wrong.empty())
    {
      vertexShader = own[0];
      geometryShader = own[1];
      fragmentShader = own[2];
    }
    return wrong;
  };
  bool compiles = true;
  std::string wrong = fill(in.Mode, compiles);
  if (!compiles && in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader)
  {
    vtkRelievoGBufferSplice::Mode without = in.Mode;
    without.PrimitiveIds = vtkRelievoPrimitiveIds::Unreliable;
    wrong = fill(without, compiles);
  }
  const std::string name = mapper->GetClassName();
  if (!wrong.empty() && in.Said.insert(name + (compiles ? wrong : "compiles not")).second)
  {
    vtkErrorMacro("No layers of what " << name << " draws: " << wrong << ".");
  }
  const bool numbered = vtkRelievoGBufferSplice::GetPrimitiveSource(mapper, actor) !=
    vtkRelievoGBufferSplice::GetPrimitiveSource(fragmentShader);
  if (wrong.empty() && numbered && in.Layout.IdWord >= 0 &&
    in.Mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader &&
    in.Said.insert(name + "ids").second)
  {
    vtkErrorMacro("No cell ids of what "
      << name << " draws: with this OpenGL they need a geometry shader, which cannot hand on all "
      << "that its vertex shader puts out. Declare one output of a simple type on a line.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Writing || !mapper || !actor)
  {
    return true;
  }
  // Nor into the depth buffer alone (hidden line removal).
  unsigned char mask[4] = { 1, 1, 1, 1 };
  static_cast<vtkOpenGLRenderWindow*>(in.Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetBooleanv(GL_COLOR_WRITEMASK, mask);
  const bool writes = (mask[0] || mask[1] || mask[2] || mask[3]) &&
    program->GetFragmentShader()->GetSource().find("relievoOutput1") != std::string::npos;
  in.Target.WriteLayers(writes);
  if (!writes)
  {
    return true;
  }
  ++this->DrawCalls;
  if (in.Layout.IdWord >= 0)
  {
    const int source =
      vtkRelievoGBufferSplice::GetPrimitiveSource(program->GetFragmentShader()->GetSource());
    const std::uint32_t first = in.Draws.Add(actor, mapper, source);
    program->SetUniformi("relievoFirstPrimitive", static_cast<int>(first));
  }
  program->SetUniformf("relievoWinding", actor->GetMatrix()->Determinant() < 0.0 ? -1.0f : 1.0f);
  program->SetUniformf("relievoNear", static_cast<float>(in.View.Near));
  program->SetUniformf("relievoFar", static_cast<float>(in.View.Far));
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoGBufferPass::GetShaderStageMTime()
{
  // Asked outside of its own drawing by keys that were copied meanwhile: there it splices nothing.
  Internals& in = *this->Internal;
  if (!in.Writing || in.Strayed)
  {
    in.StructureTime.Modified();
    in.Strayed = !in.Writing;
  }
  return in.StructureTime.GetMTime();
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
