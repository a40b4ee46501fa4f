// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScopedRenderer.h"

#include "vtkLightCollection.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

namespace
{
// The place of a pose, and a camera there that is turned as it is.
void SetPose(vtkRelievoCameraModel* sensor, vtkCamera* camera)
{
  const double* R = sensor->GetRotation();
  const double* t = sensor->GetTranslation();
  const double distance = camera->GetDistance();
  double eye[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = -(R[i] * t[0] + R[3 + i] * t[1] + R[6 + i] * t[2]);
    focus[i] = eye[i] + distance * R[6 + i];
  }
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(-R[3], -R[4], -R[5]);
}
}

//------------------------------------------------------------------------------
vtkRelievoScopedRenderer::vtkRelievoScopedRenderer(
  vtkRenderer* renderer, vtkRelievoCameraModel* sensor)
  : Renderer(renderer)
  , Guard(renderer)
  , Attached(vtkRelievoPass::SafeDownCast(renderer->GetPass()) != nullptr)
  , Gradient(renderer->GetGradientBackground())
  , Textured(renderer->GetTexturedBackground())
{
  if (renderer->IsActiveCameraCreated())
  {
    this->View->DeepCopy(renderer->GetActiveCamera());
  }
  this->Behind = renderer->GetBackgroundTexture();
  renderer->GetRenderWindow()->SetUseOffScreenBuffers(true);
  renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  renderer->SetActiveCamera(this->View);
  SetPose(sensor, this->View);
  this->FreezeLights();
  this->HideOthers();
  vtkRelievoPass::Attach(renderer);
}

//------------------------------------------------------------------------------
vtkRelievoScopedRenderer::~vtkRelievoScopedRenderer()
{
  for (const Follower& each : this->Followers)
  {
    each.Light->SetLightType(each.Type);
    each.Light->SetPosition(each.Position);
    each.Light->SetFocalPoint(each.FocalPoint);
    each.Light->SetTransformMatrix(each.Matrix);
  }
  for (vtkProp* prop : this->Overlays)
  {
    prop->VisibilityOn();
  }
  for (vtkRenderer* other : this->Others)
  {
    other->DrawOn();
  }
  this->Renderer->SetGradientBackground(this->Gradient);
  this->Renderer->SetTexturedBackground(this->Textured);
  this->Renderer->SetBackgroundTexture(this->Behind);
  if (!this->Attached)
  {
    vtkRelievoPass::Detach(this->Renderer);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoScopedRenderer::FreezeLights()
{
  vtkLightCollection* lights = this->Renderer->GetLights();
  if (lights->GetNumberOfItems() == 0 && this->Renderer->GetAutomaticLightCreation())
  {
    this->Renderer->CreateLight(); // as the first frame does
  }
  this->Renderer->UpdateLightsGeometryToFollowCamera();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (light->LightTypeIsSceneLight())
    {
      continue;
    }
    Follower follower;
    follower.Light = light;
    follower.Type = light->GetLightType();
    light->GetPosition(follower.Position);
    light->GetFocalPoint(follower.FocalPoint);
    follower.Matrix = light->GetTransformMatrix();
    double position[3];
    double focus[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focus);
    light->SetLightTypeToSceneLight();
    light->SetTransformMatrix(nullptr);
    light->SetPosition(position);
    light->SetFocalPoint(focus);
    this->Followers.push_back(follower);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoScopedRenderer::HideOthers()
{
  vtkCollectionSimpleIterator it;
  this->Renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = this->Renderer->GetViewProps()->GetNextProp(it))
  {
    if (prop->IsA("vtkActor2D") && prop->GetVisibility())
    {
      prop->VisibilityOff();
      this->Overlays.push_back(prop);
    }
  }
  vtkRendererCollection* others = this->Renderer->GetRenderWindow()->GetRenderers();
  others->InitTraversal(it);
  while (vtkRenderer* other = others->GetNextRenderer(it))
  {
    if (other != this->Renderer && other->GetDraw())
    {
      other->DrawOff();
      this->Others.push_back(other);
    }
  }
}
