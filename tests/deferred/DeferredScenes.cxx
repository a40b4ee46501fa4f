// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeferredScenes.h"

#include "Check.h"
#include "ImageCompare.h"
#include "Props.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkElevationFilter.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

namespace relievoTest
{
namespace
{
vtkSmartPointer<vtkActor> Add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return vtkSmartPointer<vtkActor>(actor);
}
}

//------------------------------------------------------------------------------
DeferredScene::DeferredScene(int width, int height)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(30);
  sphere->SetRadius(0.8);
  this->Actors.push_back(Add(this->Renderer, sphere));
  this->Actors[0]->SetPosition(-0.7, 0.8, 0.0);
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 1.0, 0.0);
  cone->SetHeight(1.5);
  cone->SetResolution(40);
  this->Actors.push_back(Add(this->Renderer, cone));
  this->Actors[1]->SetPosition(1.0, 0.75, 0.4);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-3.0, 0.0, 3.0);
  floor->SetPoint1(3.0, 0.0, 3.0);
  floor->SetPoint2(-3.0, 0.0, -3.0);
  this->Actors.push_back(Add(this->Renderer, floor));
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-3.0, 0.0, -2.0);
  wall->SetPoint1(3.0, 0.0, -2.0);
  wall->SetPoint2(-3.0, 2.0, -2.0);
  this->Actors.push_back(Add(this->Renderer, wall));
  const double colors[4][3] = { { 0.9, 0.35, 0.2 }, { 0.25, 0.7, 0.9 }, { 0.8, 0.8, 0.75 },
    { 0.35, 0.6, 0.3 } };
  for (int i = 0; i < 4; ++i)
  {
    this->Actors[i]->GetProperty()->SetColor(colors[i][0], colors[i][1], colors[i][2]);
  }
  this->Renderer->SetBackground(0.1, 0.15, 0.3);
  this->Renderer->AutomaticLightCreationOff();
  this->Window = MakeWindow(width, height, this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(2.5, 3.0, 6.0);
  camera->SetFocalPoint(0.0, 0.5, 0.0);
  camera->SetViewAngle(40.0);
  camera->SetParallelScale(2.2);
  camera->SetClippingRange(1.0, 16.0);
  this->Frame = vtkRelievoPass::Attach(this->Renderer);
  this->Stage = vtkRelievoDeferredStage::SafeDownCast(this->Frame->GetStage("deferred"));
}

//------------------------------------------------------------------------------
vtkLight* DeferredScene::AddLight()
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, 5.0, 2.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
void DeferredScene::ColorByHeight(int actor)
{
  vtkNew<vtkElevationFilter> heights;
  heights->SetInputConnection(this->Actors[actor]->GetMapper()->GetInputConnection(0, 0));
  heights->SetLowPoint(0.0, -0.8, 0.0);
  heights->SetHighPoint(0.0, 0.8, 0.0);
  this->Actors[actor]->GetMapper()->SetInputConnection(heights->GetOutputPort());
}

//------------------------------------------------------------------------------
void DeferredScene::SetTexture(int actor)
{
  this->Actors[actor]->SetTexture(MakeChecker(false));
}

//------------------------------------------------------------------------------
int DeferredScene::CompareWithVTK(const std::string& what)
{
  this->Stage->EnabledOff();
  const auto own = Picture(this->Window);
  this->Stage->EnabledOn();
  const auto deferred = Picture(this->Window);
  const int largest = GetLargestDifference(deferred, own);
  if (largest > 2)
  {
    WriteImage(OutputFolder() + "/" + what + ".png", deferred);
    WriteImage(OutputFolder() + "/" + what + ".vtk.png", own);
  }
  return largest;
}
}
