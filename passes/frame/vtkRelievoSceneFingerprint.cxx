// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSceneFingerprint.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCameraPass.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageProcessingPass.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoPropMTime.h"
#include "vtkRelievoPropParts.h"
#include "vtkRelievoStage.h"
#include "vtkRenderPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProperty.h"
#include "vtkTextActor3D.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace
{
constexpr double Rounding = 1e-7; // of a projection: moves no picture by a hundredth of a pixel

bool IsNear(const std::vector<double>& one, const std::vector<double>& other)
{
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](double a, double b) {
    return a == b || std::abs(a - b) <= Rounding * std::max(std::abs(a), std::abs(b));
  });
}

class Values
{
public:
  std::vector<std::uint64_t> All;

  void Add(std::uint64_t value) { this->All.push_back(value); }
  void Add(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    this->All.push_back(bits);
  }
  void Add(const double* values, int count)
  {
    std::for_each(values, values + count, [this](double value) { this->Add(value); });
  }
  void Add(vtkObject* object)
  {
    this->Add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object)));
    this->Add(static_cast<std::uint64_t>(object ? object->GetMTime() : 0));
  }
  void Add(vtkTexture* texture)
  {
    this->Add(static_cast<vtkObject*>(texture));
    this->Add(static_cast<std::uint64_t>(vtkRelievoPropMTime::OfTexture(texture)));
  }
};

void AddView(Values& state, const vtkRelievoFrameContext& context)
{
  const vtkRelievoFrameCamera& view = context.SteadyView;
  state.Add(&view.WorldToView[0][0], 16);
  for (const int value : view.Viewport)
  {
    state.Add(static_cast<double>(value));
  }
  double tile[4];
  context.Window->GetTileViewport(tile);
  state.Add(tile, 4);
  for (int axis = 0; axis < 2; ++axis)
  {
    state.Add(static_cast<double>(context.Window->GetSize()[axis]));
  }
  state.Add(static_cast<double>(context.Window->GetMultiSamples()));
  state.Add(context.Window->GetUseSRGBColorSpace() ? 1.0 : 0.0);
}

// VTK's depth offsets, which are global to the process.
void AddOffsets(Values& state)
{
  double values[5];
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(values[0], values[1]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(values[2], values[3]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(values[4]);
  state.Add(values, 5);
  state.Add(static_cast<double>(vtkMapper::GetResolveCoincidentTopology()));
  state.Add(static_cast<double>(vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces()));
}

// Includes the passes that the pass delegates to, recursively.
void AddPass(Values& state, vtkRenderPass* pass)
{
  state.Add(static_cast<vtkObject*>(pass));
  if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    vtkCollectionSimpleIterator it;
    if (passes)
    {
      passes->InitTraversal(it);
      while (vtkRenderPass* each = passes->GetNextRenderPass(it))
      {
        AddPass(state, each);
      }
    }
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    AddPass(state, camera->GetDelegatePass());
  }
  else if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    AddPass(state, image->GetDelegatePass());
  }
  else if (auto* frame = vtkRelievoFramePass::SafeDownCast(pass))
  {
    AddPass(state, frame->GetDelegatePass());
  }
}

// VTK's processing of the environment texture, with its own settings.
void AddEnvironment(Values& state, vtkOpenGLRenderer* renderer)
{
  if (renderer && renderer->GetUseImageBasedLighting())
  {
    state.Add(static_cast<vtkObject*>(renderer->GetEnvMapLookupTable()));
    state.Add(static_cast<vtkObject*>(renderer->GetEnvMapIrradiance()));
    state.Add(static_cast<vtkObject*>(renderer->GetEnvMapPrefiltered()));
    state.Add(static_cast<vtkObject*>(renderer->GetSphericalHarmonics()));
  }
}

void AddRenderer(Values& state, vtkRenderer* renderer)
{
  // The camera and the lights are added by value.
  state.Add(renderer->GetBackground(), 3);
  state.Add(renderer->GetBackground2(), 3);
  state.Add(renderer->GetAmbient(), 3);
  state.Add(renderer->GetBackgroundTexture());
  state.Add(renderer->GetEnvironmentTexture());
  AddEnvironment(state, vtkOpenGLRenderer::SafeDownCast(renderer));
  for (const vtkRelievoFrameLight& light : vtkRelievoFrameScene::FindLights(renderer))
  {
    double place[3];
    state.Add(static_cast<vtkObject*>(light.Light));
    light.Light->GetTransformedPosition(place);
    state.Add(place, 3);
    light.Light->GetTransformedFocalPoint(place);
    state.Add(place, 3);
  }
}

void AddActor(Values& state, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  state.Add(static_cast<vtkObject*>(property));
  state.Add(static_cast<vtkObject*>(actor->GetBackfaceProperty()));
  state.Add(actor->GetTexture());
  for (const auto& named : property->GetAllTextures())
  {
    state.Add(named.second);
  }
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  state.Add(static_cast<std::uint64_t>(shaders->GetShaderMTime()));
  state.Add(static_cast<vtkObject*>(shaders->GetVertexCustomUniforms()));
  state.Add(static_cast<vtkObject*>(shaders->GetGeometryCustomUniforms()));
  state.Add(static_cast<vtkObject*>(shaders->GetFragmentCustomUniforms()));
  vtkMapper* mapper = actor->GetMapper();
  state.Add(static_cast<vtkObject*>(mapper));
  if (mapper)
  {
    state.Add(static_cast<std::uint64_t>(vtkRelievoPropMTime::OfInputs(mapper)));
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    state.Add(static_cast<vtkObject*>(glyphs->GetBlockAttributes()));
  }
  else if (auto* blocks = vtkRelievoCompositeMapper::SafeDownCast(mapper))
  {
    state.Add(static_cast<vtkObject*>(blocks->GetCompositeDataDisplayAttributes()));
  }
}

// Texts in the scene change without notification.
void AddText(Values& state, vtkProp* prop)
{
  if (auto* text = vtkTextActor3D::SafeDownCast(prop))
  {
    state.Add(static_cast<vtkObject*>(text->GetTextProperty()));
  }
  else if (auto* billboard = vtkBillboardTextActor3D::SafeDownCast(prop))
  {
    state.Add(static_cast<vtkObject*>(billboard->GetTextProperty()));
  }
}

// The level of detail that a prop shows: chosen by time, before the frame. Actors that choose while
// they draw depend on the time set on the renderer.
void AddLevel(Values& state, vtkProp* prop)
{
  if (auto* levels = vtkLODProp3D::SafeDownCast(prop))
  {
    state.Add(static_cast<double>(levels->GetLastRenderedLODID()));
  }
}

void AddProps(Values& state, vtkRenderer* renderer)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (!prop->GetVisibility() || vtkActor2D::SafeDownCast(prop))
    {
      continue;
    }
    prop->GetBounds(); // updates the prop's pipeline
    state.Add(static_cast<vtkObject*>(prop));
    state.Add(static_cast<std::uint64_t>(prop->GetRedrawMTime()));
    AddLevel(state, prop);
    vtkRelievoPropParts::Collect(prop, parts);
    for (const vtkRelievoPropParts::Part& part : parts)
    {
      state.Add(static_cast<vtkObject*>(part.Prop));
      AddText(state, part.Prop);
      vtkMatrix4x4* matrix = part.Matrix ? part.Matrix : part.Prop->GetMatrix();
      if (matrix)
      {
        state.Add(matrix->GetData(), 16);
      }
      if (auto* actor = vtkActor::SafeDownCast(part.Prop))
      {
        AddActor(state, actor);
        continue;
      }
      // Annotations consist of inner props.
      vtkNew<vtkPropCollection> inner;
      part.Prop->GetActors(inner);
      vtkCollectionSimpleIterator each;
      inner->InitTraversal(each);
      while (vtkProp* piece = inner->GetNextProp(each))
      {
        state.Add(static_cast<vtkObject*>(piece));
        if (auto* actor = vtkActor::SafeDownCast(piece))
        {
          AddActor(state, actor);
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> vtkRelievoSceneFingerprint::MakeFirst(
  const vtkRelievoFrameContext& context)
{
  Values state;
  this->Changes.Watch(context.Renderer);
  state.Add(this->Changes.GetCount());
  AddView(state, context);
  AddRenderer(state, context.Renderer);
  return state.All;
}

//------------------------------------------------------------------------------
vtkRelievoSceneFingerprint::State vtkRelievoSceneFingerprint::Make(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages)
{
  Values state;
  state.All = this->MakeFirst(context);
  AddProps(state, context.Renderer);
  AddOffsets(state);
  AddPass(state, context.Delegate);
  for (vtkRelievoStage* stage : stages)
  {
    state.Add(static_cast<vtkObject*>(stage));
    state.Add(static_cast<std::uint64_t>(stage->GetDataTime()));
  }
  const double* projection = &context.SteadyView.ViewToNDC[0][0];
  return { std::move(state.All), { projection, projection + 16 } };
}

//------------------------------------------------------------------------------
void vtkRelievoSceneFingerprint::Take(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages)
{
  State now = this->Make(context, stages);
  if (IsNear(now.Projection, this->Stored.Projection))
  {
    now.Projection =
      this->Stored.Projection; // unchanged, so that small steps of many frames add up
  }
  this->Stored = std::move(now);
}

//------------------------------------------------------------------------------
bool vtkRelievoSceneFingerprint::IsOf(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages)
{
  const std::vector<std::uint64_t> first = this->MakeFirst(context);
  const std::vector<std::uint64_t>& stored = this->Stored.Values;
  if (stored.size() < first.size() || !std::equal(first.begin(), first.end(), stored.begin()))
  {
    return false; // the view has changed, so the props need no check
  }
  const State now = this->Make(context, stages);
  return now.Values == this->Stored.Values && IsNear(now.Projection, this->Stored.Projection);
}
