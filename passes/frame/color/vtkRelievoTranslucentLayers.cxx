// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTranslucentLayers.h"

#include "vtkActor.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropCollection.h"
#include "vtkRelievoColorTarget.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTranslucentDepth.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
template <typename Test>
bool AnyProp(const vtkRelievoFrameContext& context, const Test& test)
{
  vtkProp** props = context.State->GetPropArray();
  return std::any_of(props, props + context.State->GetPropArrayCount(), test);
}

bool HasSurfaces(const vtkRelievoFrameContext& context)
{
  return AnyProp(
    context, [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

bool HasVolumes(const vtkRelievoFrameContext& context)
{
  return AnyProp(context, [](vtkProp* prop) {
    vtkNew<vtkPropCollection> volumes;
    prop->GetVolumes(volumes);
    return volumes->GetNumberOfItems() > 0;
  });
}

// Whether there are points that add light without covering, those out of view included, so that a
// pane looks the same for every direction of the camera.
bool HasShiningPoints(const vtkRelievoFrameContext& context)
{
  vtkPropCollection* props = context.Renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    vtkNew<vtkPropCollection> actors;
    prop->GetActors(actors);
    for (int i = 0; prop->GetVisibility() && i < actors->GetNumberOfItems(); ++i)
    {
      auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
      auto* points = vtkPointGaussianMapper::SafeDownCast(actor ? actor->GetMapper() : nullptr);
      if (points && points->GetEmissive())
      {
        return true;
      }
    }
  }
  return false;
}

// Whether a pass of this class is drawing the prop.
template <typename Pass>
bool IsDrawnBy(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; keys && keys->Has(key) && i < keys->Length(key); ++i)
  {
    if (Pass::SafeDownCast(keys->Get(key, i)))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoTranslucentLayers::RightsAlpha(const vtkRelievoFrameContext& context)
{
#ifdef RELIEVO_VTK_AVERAGED_TRANSMITTANCE
  return context.ReadsColor && !context.Renderer->GetUseDepthPeeling() &&
    !context.Renderer->GetUseFXAA(); // FXAA smooths the present picture when surfaces are blended
#else
  static_cast<void>(context);
  return false;
#endif
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::Begin(
  vtkRelievoFrameContext& context, vtkRelievoColorTarget& color)
{
  this->Context = &context;
  this->Color = &color;
  this->Any = this->IsOpen = this->Drawn = false;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::Ask()
{
  if (!this->Context || !this->Color->IsBound())
  {
    return;
  }
  if (this->IsOpen && this->Drawn)
  {
    this->Close();
  }
  if (!this->IsOpen && HasSurfaces(*this->Context))
  {
    this->Open();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::BeginSurfaces(vtkProp* sentinel)
{
  if (!this->Context)
  {
    return;
  }
  // Dual peeling asks no props, and arrives here with its own framebuffer bound for drawing.
  const bool bound = this->Color->IsBound() ||
    (this->Color->IsBound(true) && IsDrawnBy<vtkDualDepthPeelingPass>(sentinel));
  if (!this->IsOpen && bound && HasSurfaces(*this->Context))
  {
    this->Open();
  }
  if (this->IsOpen && !this->Drawn)
  {
    this->Drawn = true;
#ifdef RELIEVO_VTK_AVERAGED_TRANSMITTANCE
    this->Averaged = IsDrawnBy<vtkOrderIndependentTranslucentPass>(sentinel);
    if (this->Averaged)
    {
      this->Color->Clear(*this->Context, -1.0f);
    }
#endif
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::BeginVolumes()
{
  if (!this->Context || !this->Color->IsBound() || !HasVolumes(*this->Context))
  {
    return;
  }
  if (this->IsOpen && this->Drawn)
  {
    this->Close();
  }
  if (!this->IsOpen)
  {
    this->Open();
  }
  this->Drawn = true;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::Open()
{
  if (!this->Any)
  {
    vtkRelievoScreenTarget* apart = this->Context->Translucent;
    if (apart && !apart->Prepare(*this->Context, {}).empty())
    {
      return;
    }
    this->Color->Separate(*this->Context);
    if (apart)
    {
      apart->Begin(*this->Context);
      apart->End();
    }
    this->Any = true;
  }
  this->Color->Clear(*this->Context, 0.0f);
  this->IsOpen = true;
  this->Drawn = this->Averaged = false;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::Close()
{
  this->Color->Resolve(*this->Context);
  vtkShaderProgram* program = this->Context->Translucent
    ? this->ToLinear.Ready(*this->Context, "frame/layerFS.glsl", { vtkRelievoResources::Drawn })
    : nullptr;
  if (program)
  {
    program->SetUniformi("relievoAveraged", this->Averaged);
    program->SetUniformi("relievoShines", HasShiningPoints(*this->Context));
    this->Context->Translucent->GoOn(*this->Context);
    vtkOpenGLState* state = this->Context->Window->GetState();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    this->ToLinear.Draw(*this->Context, this->Context->Translucent->GetArea());
    this->Context->Translucent->End();
    this->Context->Provide(vtkRelievoResources::Translucent, this->Context->Translucent);
  }
  if (this->Context->PutBack || !this->Context->Translucent)
  {
    program = this->ToColor.Ready(*this->Context, "frame/putBackFS.glsl",
      { vtkRelievoResources::Color, vtkRelievoResources::Drawn });
    if (program)
    {
      program->SetUniformi("relievoAveraged", this->Averaged);
      this->Color->Draw(*this->Context, this->ToColor, true);
    }
  }
  this->IsOpen = false;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::End()
{
  if (this->IsOpen && this->Drawn)
  {
    this->Close();
  }
  this->IsOpen = false;
  if (this->Context && this->Context->Find(vtkRelievoResources::Translucent) &&
    this->Context->TranslucentDepth && this->Context->TranslucentDepth->Draw(*this->Context))
  {
    this->Context->Provide(vtkRelievoResources::TranslucentDepth, this->Context->TranslucentDepth);
  }
  this->Context = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoTranslucentLayers::Release(vtkWindow* window)
{
  this->ToLinear.Release(window);
  this->ToColor.Release(window);
}
