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
#include <vtkCompositePolyDataMapper2.h>
#include <vtkFieldData.h>
#include <vtkGlyph3DMapper.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowPass.h>
#include <vtkSelection.h>
#include <vtkTexture.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace relievoTest
{
namespace
{
int Pick(std::mt19937& random, int count)
{
  return static_cast<int>(random() % static_cast<unsigned int>(count));
}

double Between(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random() % 1000u) / 999.;
}

const char* const LayerNames[] = { "depth", "normal", "cell", "actor", "albedo", "position",
  "shadow_0", "shadow_2", "shadow_3" };
const int Sizes[][2] = { { 160, 120 }, { 121, 140 }, { 200, 60 } };

// Ground, box, ball, blocks, glyphs, a card with holes, a wall.
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
    vtkNew<vtkCompositePolyDataMapper2> mapper;
    mapper->SetInputDataObject(blocks);
    mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
    actor->SetMapper(mapper);
  }
  else if (kind == 4)
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
HistoryState::HistoryState()
{
  const glm::dvec3 places[NumberOfProps] = { { 0., 0., 0. }, { 0.2, 0.8, -0.1 }, { -1.3, 0.7, 0.6 },
    { 1.2, 0.5, 1. }, { -0.4, 1.4, 0.8 }, { 0.9, 1.5, -0.9 }, { -1.6, 0.7, -1.3 } };
  for (int i = 0; i < NumberOfProps; ++i)
  {
    this->Props[i].Position = places[i];
    this->Order.push_back(i);
  }
  const glm::dvec3 lights[NumberOfLights] = { { -3., 4., -2. }, { 2., 5., 1. }, { -1., 3.5, -1.5 },
    { 0.5, 2.6, 1. } };
  for (int i = 0; i < NumberOfLights; ++i)
  {
    this->Lights[i].Position = lights[i];
  }
}

//------------------------------------------------------------------------------
std::string HistoryState::Step(std::mt19937& random)
{
  Prop& prop = this->Props[Pick(random, NumberOfProps)];
  Light& light = this->Lights[Pick(random, NumberOfLights)];
  switch (Pick(random, 34))
  {
    case 0:
      prop.Visible = !prop.Visible;
      return "visibility";
    case 1:
      prop.Position += glm::dvec3(Between(random, -0.3, 0.3), 0., Between(random, -0.3, 0.3));
      return "position";
    case 2:
      prop.Turn += 20.;
      return "turn";
    case 3:
      prop.Opacity = prop.Opacity < 1. ? 1. : 0.5;
      return "opacity";
    case 4:
      prop.Representation = Pick(random, 3);
      return "representation";
    case 5:
      prop.Interpolation = Pick(random, 4);
      return "interpolation";
    case 6:
      prop.Culling = Pick(random, 3);
      return "culling";
    case 7:
      prop.Size = 1. + Pick(random, 4);
      return "size of points and lines";
    case 8:
      prop.Edges = !prop.Edges;
      return "edges";
    case 9:
      prop.Clipped = !prop.Clipped;
      return "clipping plane";
    case 10:
      prop.Casts = Pick(random, 3) - 1;
      return "casting";
    case 11:
      prop.Receives = !prop.Receives;
      return "receiving";
    case 12:
    case 13:
    {
      const int number = Pick(random, NumberOfProps);
      const auto found = std::find(this->Order.begin(), this->Order.end(), number);
      if (found != this->Order.end())
      {
        this->Order.erase(found);
        return "a prop goes";
      }
      this->Order.push_back(number);
      return "a prop comes";
    }
    case 14:
      light.On = !light.On;
      return "light's switch";
    case 15:
      light.Position += glm::dvec3(Between(random, -0.5, 0.5), 0., Between(random, -0.5, 0.5));
      return "light's position";
    case 16:
      light.Attenuation = 0.5 * Pick(random, 3);
      return "light's attenuation";
    case 17:
      light.Casts = !light.Casts;
      return "light's casting";
    case 18:
    case 19:
      this->Eye += glm::dvec3(Between(random, -0.4, 0.4), 0., Between(random, -0.4, 0.4));
      return "a small move of the camera";
    case 20:
      this->Eye = glm::dvec3(Between(random, -4., 4.), Between(random, 0.5, 5.), 5.);
      this->Focus = glm::dvec3(Between(random, -1., 1.), 0.5, 0.);
      return "another camera";
    case 21:
      this->ViewAngle = Between(random, 8., 50.);
      return "view angle";
    case 22:
      this->Parallel = !this->Parallel;
      return "projection";
    case 23:
    {
      const auto& size = Sizes[Pick(random, 3)];
      std::copy(size, size + 2, this->Size);
      return "window's size";
    }
    case 24:
      (Pick(random, 2) ? this->Part : this->Peeling) ^= true;
      return "part of the window or peeling";
    case 25:
      (Pick(random, 2) ? this->Offset : this->Stereo) ^= true;
      return "polygon offset or stereo";
    case 26:
      this->Attached = !this->Attached;
      return "attach or detach";
    case 27:
      this->Shadows = !this->Shadows;
      return "shadows";
    case 28:
      this->Method = Pick(random, 3);
      return "method";
    case 29:
      this->MapSize = 64 << Pick(random, 4);
      return "map size";
    case 30:
      this->Radius = Pick(random, 4);
      return "radius";
    case 31:
      (Pick(random, 2) ? this->Bias : this->Strength) = 0.5 * (1 + Pick(random, 2));
      return "bias or strength";
    case 32:
    {
      const std::string name = LayerNames[Pick(random, 9)];
      const auto found = std::find(this->Layers.begin(), this->Layers.end(), name);
      if (found != this->Layers.end())
      {
        this->Layers.erase(found);
        return "without layer " + name;
      }
      this->Layers.push_back(name);
      return "layer " + name;
    }
    default:
      this->Shown = Pick(random, 2) ? "" : LayerNames[Pick(random, 9)];
      return "shown: " + this->Shown;
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
    property->SetOpacity(prop.Opacity);
    property->SetRepresentation(prop.Representation);
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
  this->Window->SetStereoRender(state.Stereo);
  this->Renderer->SetViewport(state.Part ? 0.25 : 0., 0., 1., state.Part ? 0.8 : 1.);
  this->Renderer->SetUseDepthPeeling(state.Peeling);
  vtkMapper::SetResolveCoincidentTopology(
    state.Offset ? VTK_RESOLVE_POLYGON_OFFSET : VTK_RESOLVE_OFF);
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
  vtkRelievoShadowPass* shadows = frame->GetShadowPass();
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
