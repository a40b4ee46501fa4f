// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistoryScene.h"

#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Stage.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkFieldData.h>
#include <vtkGlyph3DMapper.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkSelection.h>
#include <vtkTexture.h>
#include <vtkWindowToImageFilter.h>

namespace relievoTest
{
int Pick(std::mt19937& random, int count)
{
  return static_cast<int>(random() % static_cast<unsigned int>(count));
}

namespace
{
// Ground, box, ball, blocks, glyphs, a card with holes, a wall.
constexpr int Glyphs = 4;

vtkSmartPointer<vtkActor> MakeActor(vtkRenderer* renderer, int kind)
{
  auto actor = AddActor(renderer,
    kind == 0     ? MakeBox(6., 0.02, 6.)
      : kind == 2 ? MakeBall(0.6)
      : kind == 5 ? MakeSquare()
                  : MakeBox(0.6 + 0.2 * kind, 1.4, 0.5));
  if (kind == 3)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, Moved(MakeBall(0.4), 0., 0., 0.));
    blocks->SetBlock(1, Moved(MakeBall(0.3), 0.5, 0.4, 0.));
    vtkNew<vtkRelievoCompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
    actor->SetMapper(mapper);
  }
  else if (kind == Glyphs)
  {
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(MakePolygons({ { 0., 0., 0. }, { 0.7, 0.2, 0. }, { -0.6, 0., 0.5 } }));
    mapper->SetSourceData(MakeBall(0.25));
    actor->SetMapper(mapper);
  }
  else if (kind == 5)
  {
    actor->SetTexture(MakeChecker(true));
  }
  actor->GetProperty()->SetColor(0.4 + 0.08 * kind, 0.9 - 0.07 * kind, 0.6);
  renderer->RemoveActor(actor);
  return actor;
}
}

//------------------------------------------------------------------------------
HistoryScene::HistoryScene()
  : Window(MakeWindow(160, 120, this->Back))
{
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetStereoTypeToAnaglyph();
  this->Renderer->SetAutomaticLightCreation(false);
  this->Renderer->SetBackground(0.2, 0.25, 0.3);
  for (int i = 0; i < HistoryState::NumberOfProps; ++i)
  {
    this->Actors.push_back(MakeActor(this->Renderer, i));
  }
  const double cones[HistoryState::NumberOfLights] = { 0., 0., 45., 90. };
  for (const double cone : cones)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetFocalPoint(0., 0.3, 0.);
    light->SetPositional(cone > 0.);
    light->SetConeAngle(cone);
    light->SetIntensity(0.4);
    this->Renderer->AddLight(light);
    this->Lights.emplace_back(light);
  }
}

//------------------------------------------------------------------------------
HistoryScene::~HistoryScene()
{
  vtkMapper::SetResolveCoincidentTopologyToOff();
}

//------------------------------------------------------------------------------
void HistoryScene::Take(const HistoryState& state)
{
  this->Renderer->RemoveAllViewProps();
  for (const int i : state.Order)
  {
    this->Renderer->AddActor(this->Actors[i]);
  }
  for (int i = 0; i < HistoryState::NumberOfProps; ++i)
  {
    const HistoryState::Prop& prop = state.Props[i];
    vtkActor* actor = this->Actors[i];
    vtkProperty* property = actor->GetProperty();
    actor->SetVisibility(prop.Visible);
    actor->SetPosition(prop.Position.x, prop.Position.y, prop.Position.z);
    actor->SetOrientation(0., prop.Turn, 0.);
    if (i == Glyphs && property->GetOpacity() != prop.Opacity)
    {
      actor->GetMapper()->Modified(); // VTK keeps its colours, with the opacity in them
    }
    property->SetOpacity(prop.Opacity);
    // VTK's mapper of glyphs never sets a width of lines: it draws with the last one.
    const bool widthOfLast = i == Glyphs && prop.Representation == VTK_WIREFRAME;
    property->SetRepresentation(widthOfLast ? VTK_SURFACE : prop.Representation);
    property->SetInterpolation(prop.Interpolation);
    property->SetBackfaceCulling(prop.Culling == 1);
    property->SetFrontfaceCulling(prop.Culling == 2);
    property->SetPointSize(static_cast<float>(prop.Size));
    property->SetLineWidth(static_cast<float>(prop.Size));
    property->SetEdgeVisibility(prop.Edges);
    const bool clipped = actor->GetMapper()->GetNumberOfClippingPlanes() > 0;
    if (prop.Clipped && !clipped)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.1, 0., 0.);
      plane->SetNormal(1., 0.2, 0.);
      actor->GetMapper()->AddClippingPlane(plane);
    }
    else if (!prop.Clipped && clipped)
    {
      actor->GetMapper()->RemoveAllClippingPlanes();
    }
  }
  for (int i = 0; i < HistoryState::NumberOfLights; ++i)
  {
    const HistoryState::Light& light = state.Lights[i];
    this->Lights[i]->SetSwitch(light.On);
    this->Lights[i]->SetPosition(light.Position.x, light.Position.y, light.Position.z);
    this->Lights[i]->SetShadowAttenuation(static_cast<float>(light.Attenuation));
  }
  this->Window->SetSize(state.Size[0], state.Size[1]);
  if (this->Window->GetStereoRender() != static_cast<vtkTypeBool>(state.Stereo))
  {
    // VTK draws with the last eye's matrices until the camera is modified.
    this->Window->SetStereoRender(state.Stereo);
    this->Renderer->GetActiveCamera()->Modified();
  }
  this->Renderer->SetViewport(state.Part ? 0.25 : 0., 0., 1., state.Part ? 0.8 : 1.);
  this->Renderer->SetUseDepthPeeling(state.Peeling);
  const int offset = state.Offset ? VTK_RESOLVE_POLYGON_OFFSET : VTK_RESOLVE_OFF;
  if (vtkMapper::GetResolveCoincidentTopology() != offset)
  {
    vtkMapper::SetResolveCoincidentTopology(offset);
  }
  if (this->Offset != state.Offset)
  {
    // VTK reads it when it builds shaders, and does not build them anew for it; the mappers that a
    // mapper of glyphs or blocks holds do not hear that it was modified.
    for (vtkActor* actor : this->Actors)
    {
      actor->GetMapper()->ReleaseGraphicsResources(this->Window);
      actor->GetMapper()->Modified();
    }
    this->Offset = state.Offset;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(state.Eye.x, state.Eye.y, state.Eye.z);
  camera->SetFocalPoint(state.Focus.x, state.Focus.y, state.Focus.z);
  camera->SetViewUp(0., 1., 0.);
  camera->SetViewAngle(state.ViewAngle);
  camera->SetParallelScale(0.1 * state.ViewAngle);
  camera->SetParallelProjection(state.Parallel);
  this->Renderer->ResetCameraClippingRange(-4., 4., -1., 3., -4., 4.);
  if (!state.Attached)
  {
    vtkRelievoPass::Detach(this->Renderer);
    return;
  }
  vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Renderer);
  frame->SetShadows(state.Shadows);
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  shadows->SetMethod(state.Method);
  shadows->SetMapSize(state.MapSize);
  shadows->SetFilterRadius(state.Radius);
  shadows->SetBias(state.Bias);
  shadows->SetStrength(state.Strength);
  for (int i = 0; i < HistoryState::NumberOfProps; ++i)
  {
    shadows->SetPropCasts(this->Actors[i], state.Props[i].Casts);
    shadows->SetPropReceives(this->Actors[i], state.Props[i].Receives);
  }
  for (int i = 0; i < HistoryState::NumberOfLights; ++i)
  {
    shadows->SetLightCasts(this->Lights[i], state.Lights[i].Casts);
  }
  frame->ReleaseLayers();
  for (const std::string& name : state.Layers)
  {
    frame->RequestLayer(name);
  }
  frame->SetDisplayLayer(state.Shown.empty() ? nullptr : state.Shown.c_str());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> HistoryScene::Draw(const HistoryState& state)
{
  auto image = Picture(this->Window);
  if (state.Attached && !state.Layers.empty())
  {
    vtkNew<vtkImageData> layers;
    RELIEVO_CHECK(vtkRelievoPass::Attach(this->Renderer)->ReadLayers(state.Layers, layers));
    for (const std::string& name : state.Layers)
    {
      // The renderer may take a part of the window only.
      image->GetFieldData()->AddArray(layers->GetPointData()->GetArray(name.c_str()));
    }
  }
  return image;
}

//------------------------------------------------------------------------------
std::string HistoryScene::Disturb(std::mt19937& random)
{
  switch (Pick(random, 6))
  {
    case 0:
    {
      vtkNew<vtkWindowToImageFilter> filter;
      filter->SetInput(this->Window);
      filter->SetScale(1 + Pick(random, 2));
      filter->ReadFrontBufferOff();
      filter->Update();
      return "screenshot";
    }
    case 1:
    {
      const Layers layers(this->Renderer, { "depth", "shadow_0" });
      return "capture";
    }
    case 2:
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(this->Renderer);
      selector->SetArea(10, 10, 50, 50);
      selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
      vtkSmartPointer<vtkSelection>::Take(selector->Select());
      return "selection";
    }
    case 3:
    {
      const int* size = this->Window->GetSize();
      const int own[2] = { size[0], size[1] };
      this->Window->SetSize(100, 180);
      this->Window->Render();
      this->Window->SetSize(own[0], own[1]);
      return "another size";
    }
    default:
      this->Window->Render();
      return "frame";
  }
}

//------------------------------------------------------------------------------
long long HistoryScene::GetBytesHeld()
{
  auto* frame = vtkRelievoPass::SafeDownCast(this->Renderer->GetPass());
  return frame ? frame->GetBytesHeld() : 0;
}
}
