// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScenes.h"

#include "Check.h"
#include "Layers.h"
#include "Props.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <iostream>

namespace relievoTest
{
//------------------------------------------------------------------------------
ShadowStage::ShadowStage(int width, int height, double scale, const glm::dvec3& origin)
  : Stage(width, height)
  , Scale(scale)
  , Origin(origin)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 eye = this->Place({ 2.5, 3., 6. });
  const glm::dvec3 focus = this->Place({ 0., 0.5, 0. });
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetClippingRange(2. * scale, 14. * scale);
  this->Renderer->SetAutomaticLightCreation(false);
  this->Renderer->SetBackground(0.2, 0.25, 0.3);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> ShadowStage::AddGround()
{
  const auto mesh = MakePolygons({ this->Place({ -3., 0., 3. }), this->Place({ 3., 0., 3. }),
    this->Place({ 3., 0., -3. }), this->Place({ -3., 0., -3. }) });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  return AddActor(this->Renderer, mesh);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> ShadowStage::AddBox(const glm::dvec3& middle, const glm::dvec3& size)
{
  const auto mesh = MakeBox(size.x, size.y, size.z);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    points->GetPoint(i, &p.x);
    p = this->Place(middle + p);
    points->SetPoint(i, &p.x);
  }
  return AddActor(this->Renderer, mesh);
}

//------------------------------------------------------------------------------
void ShadowStage::AddThings()
{
  this->AddGround()->GetProperty()->SetColor(0.8, 0.7, 0.5);
  this->AddBox({ 0.2, 0.8, -0.1 }, { 1.2, 1.6, 0.5 })->GetProperty()->SetColor(0.5, 0.8, 0.4);
  this->AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 })->GetProperty()->SetColor(0.4, 0.5, 0.9);
}

//------------------------------------------------------------------------------
void ShadowStage::AddPolesToHorizon()
{
  for (int i = 0; i < 24; ++i)
  {
    this->AddBox({ -0.6, 0.25, 2. - 2. * i }, { 0.06, 0.5, 0.06 });
    this->AddBox({ 0.9, 0.25, 1.5 - 2. * i }, { 0.06, 0.5, 0.06 });
  }
  this->AddBox({ 0., -0.05, -22. }, { 12., 0.1, 52. });
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0., 0.8, 4.);
  camera->SetFocalPoint(0., 0.3, 0.);
  camera->SetViewAngle(50.);
  camera->SetClippingRange(0.5, 60.);
  this->AddSun(-4., 1.5, -1.);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> ShadowStage::AddSun(double x, double y, double z)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  const glm::dvec3 place = this->Place({ x, y, z });
  light->SetPosition(place.x, place.y, place.z);
  light->SetFocalPoint(this->Origin.x, this->Origin.y, this->Origin.z);
  light->SetPositional(false);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> ShadowStage::AddLamp(
  const glm::dvec3& place, const glm::dvec3& focus, double coneAngle)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  const glm::dvec3 from = this->Place(place);
  const glm::dvec3 to = this->Place(focus);
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(to.x, to.y, to.z);
  light->SetPositional(true);
  light->SetConeAngle(coneAngle);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkRelievoPass* ShadowStage::GetFrame()
{
  return vtkRelievoPass::Attach(this->Renderer);
}

//------------------------------------------------------------------------------
vtkRelievoShadowStage* ShadowStage::GetShadows()
{
  return this->GetFrame()->GetShadowStage();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> CaptureShadow(ShadowStage& stage, int number)
{
  stage.GetFrame(); // attached here, because Layers would detach its own frame
  return Layers(stage.Renderer, { "shadow_" + std::to_string(number) }).Image;
}

//------------------------------------------------------------------------------
ShadowTruth TraceStage(ShadowStage& stage, int number, const EmbreeScene* truth)
{
  auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(number));
  if (!RELIEVO_CHECK_THAT(light, "no light " + std::to_string(number)))
  {
    return ShadowTruth();
  }
  EmbreeScene own;
  if (!truth)
  {
    own.AddActors(stage.Renderer);
    truth = &own;
  }
  return TraceShadow(*truth, truth->Trace(View(stage.Renderer)), light, 1e-5 * stage.Scale);
}

//------------------------------------------------------------------------------
ShadowErrors JudgeShadow(ShadowStage& stage, int number, const EmbreeScene* truth)
{
  const auto image = CaptureShadow(stage, number);
  const std::string name = "shadow_" + std::to_string(number);
  auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name.c_str()));
  // After the frame, which moves the lights that follow the camera.
  const ShadowTruth shadow = TraceStage(stage, number, truth);
  if (!RELIEVO_CHECK_THAT(
        array && array->GetNumberOfTuples() == static_cast<vtkIdType>(shadow.Verdicts.size()),
        "no layer " + name + " of the picture's size"))
  {
    return ShadowErrors();
  }
  return CompareShadow(shadow, array->GetPointer(0));
}

//------------------------------------------------------------------------------
ShadowErrors CheckShadow(ShadowStage& stage, int number, double limit, const std::string& what,
  double leastDark, const EmbreeScene* truth)
{
  const ShadowErrors errors = JudgeShadow(stage, number, truth);
  std::cout << what << ": " << errors.ToString() << "\n";
  RELIEVO_CHECK_THAT(errors.Compared > 2000 &&
      static_cast<double>(errors.Dark) >= leastDark * static_cast<double>(errors.Compared),
    what + ": too little to compare, " + errors.ToString());
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), limit, what + ": share of wrong verdicts");
  return errors;
}

//------------------------------------------------------------------------------
ShadowTruth GetInner(const ShadowTruth& truth, int radius)
{
  ShadowTruth inner = truth;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * truth.Width + x;
      bool same = true;
      for (int j = std::max(0, y - radius); j <= std::min(truth.Height - 1, y + radius); ++j)
      {
        for (int i = std::max(0, x - radius); i <= std::min(truth.Width - 1, x + radius); ++i)
        {
          same = same &&
            truth.Verdicts[static_cast<std::size_t>(j) * truth.Width + i] == truth.Verdicts[pixel];
        }
      }
      inner.Verdicts[pixel] = same ? truth.Verdicts[pixel] : ShadowTruth::Unjudged;
    }
  }
  return inner;
}
}
