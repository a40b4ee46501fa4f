// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Actors.h"
#include "Errors.h"
#include "FinitePoints.h"
#include "Look.h"
#include "Messages.h"
#include "Models.h"
#include "ObjMaterials.h"
#include "Options.h"
#include "Progress.h"
#include "Readers.h"
#include "TextureCoordinates.h"

#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoNullLight.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"

#include <algorithm>

namespace scene
{
namespace
{
void SetShading(vtkRenderer* renderer, Shading kind)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator place;
  actors->InitTraversal(place);
  while (vtkActor* actor = actors->GetNextActor(place))
  {
    switch (kind)
    {
      case Shading::Flat:
        actor->GetProperty()->SetInterpolationToFlat();
        break;
      case Shading::Gouraud:
        actor->GetProperty()->SetInterpolationToGouraud();
        break;
      case Shading::Phong:
        actor->GetProperty()->SetInterpolationToPhong();
        break;
      case Shading::PBR:
        actor->GetProperty()->SetInterpolationToPBR();
        if (vtkTexture* texture = actor->GetTexture()) // which PBR does not look at
        {
          texture->UseSRGBColorSpaceOn();
          actor->GetProperty()->SetBaseColorTexture(texture);
        }
        break;
      case Shading::FromFile:
        break;
    }
  }
}

//------------------------------------------------------------------------------
// Before anything is drawn, also where no frame looks.
void CheckLights(vtkRenderer* renderer, const RenderOptions& options)
{
  const std::string wrong = vtkRelievoFramePass::CheckLights(renderer);
  if (!wrong.empty() && !options.Lights.empty())
  {
    throw UsageError("--light: " + wrong + " Give them as points with --lamps FILE");
  }
  if (!wrong.empty())
  {
    throw WorkError("the files' lights: " + wrong + " Give --light, or points with --lamps FILE");
  }
}

//------------------------------------------------------------------------------
void AddLights(vtkRenderer* renderer, const RenderOptions& options)
{
  if (options.Lights.empty())
  {
    if (!options.Environment.empty() && renderer->GetLights()->GetNumberOfItems() == 0)
    {
      vtkRelievoNullLight().Place(renderer, true); // the environment lights
    }
    return; // the file's lights, or the headlight that VTK makes
  }
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  for (const LightChoice& choice : options.Lights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(choice.Position.data());
    light->SetPositional(choice.Is != LightChoice::Kind::Sun);
    light->SetConeAngle(choice.ConeAngle);
    if (choice.Is == LightChoice::Kind::Spot)
    {
      light->SetFocalPoint(choice.FocalPoint.data());
    }
    else if (choice.Is == LightChoice::Kind::Point)
    {
      // All around alike; but a light that stands on its focal point has no direction.
      light->SetFocalPoint(choice.Position[0], choice.Position[1] - 1.0, choice.Position[2]);
    }
    else
    {
      light->SetFocalPoint(0.0, 0.0, 0.0);
    }
    light->SetColor(choice.Color[0], choice.Color[1], choice.Color[2]);
    renderer->AddLight(light);
  }
}

// What was left out, by the notes on the file.
std::string WhyNothing(const std::string& path)
{
  std::string why;
  for (const std::string& note : Messages::TakeNotes())
  {
    if (note.rfind(path + ": ", 0) == 0)
    {
      why += (why.empty() ? "" : "; ") + note.substr(path.size() + 2);
    }
  }
  return why.empty() ? "no points, or no cells" : why;
}

//------------------------------------------------------------------------------
// Of a flat scene whose edge alone would be seen, such as a ground: the camera looks at its flat
// side, from above or from the right.
void TurnToFlatSide(vtkRenderer* renderer, int up)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  const std::array<double, 3> sizes = { bounds[1] - bounds[0], bounds[3] - bounds[2],
    bounds[5] - bounds[4] };
  const double least = 1e-6 * *std::max_element(sizes.begin(), sizes.end());
  const auto isFlat = [&](int axis) { return sizes[static_cast<std::size_t>(axis)] <= least; };
  const int depth = up == 2 ? 1 : 2; // what the camera looks along
  const int side = 3 - up - depth;
  const int axis = isFlat(side) ? side : up;
  if (isFlat(depth) || !isFlat(axis))
  {
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  if (axis == up)
  {
    camera->SetViewUp(direction);
  }
  double position[3] = { 0., 0., 0. };
  position[axis] = 1.;
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetPosition(position);
}
}

//------------------------------------------------------------------------------
void PlaceCamera(vtkRenderer* renderer, const RenderOptions& options)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(options.ParallelScale.has_value());
  if (options.ViewAngle)
  {
    camera->SetViewAngle(*options.ViewAngle);
  }
  if (options.Camera)
  {
    camera->SetPosition(options.Camera->Position.data());
    camera->SetFocalPoint(options.Camera->FocalPoint.data());
    camera->SetViewUp(options.Camera->ViewUp.data());
  }
  else
  {
    // Where an environment's z is: with z up, that of a world with y up is turned about x.
    const bool zUp = options.UpAxis == 2;
    camera->SetPosition(0.0, zUp ? -1.0 : 0.0, zUp ? 0.0 : 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(options.UpAxis == 0, options.UpAxis == 1, options.UpAxis == 2);
    TurnToFlatSide(renderer, options.UpAxis);
    renderer->ResetCamera();
  }
  if (options.ParallelScale)
  {
    camera->SetParallelScale(*options.ParallelScale);
  }
  renderer->ResetCameraClippingRange(); // whose gaps depend on the scale
  if (options.Clip)
  {
    camera->SetClippingRange((*options.Clip)[0], (*options.Clip)[1]);
  }
}

namespace
{
//------------------------------------------------------------------------------
// They follow the reader's time.
void AddOwnLights(const PosedModel& model, vtkRenderer* renderer)
{
  for (int i = 0; i < model.Reader->GetNumberOfLights(); ++i)
  {
    renderer->AddLight(model.Reader->GetLight(i));
  }
}

//------------------------------------------------------------------------------
bool IsMapped(const RenderOptions& options)
{
  return !options.NormalMap.empty() || !options.HeightMap.empty();
}

//------------------------------------------------------------------------------
// By what the last model's animation lasts.
void WidenTimes(Scene& scene)
{
  vtkInformation* information = scene.Models.back().Reader->GetOutputInformation(0);
  if (information->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    const double* own = information->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    const std::array<double, 2> all = scene.Times.value_or(std::array<double, 2>{ own[0], own[1] });
    scene.Times = { std::min(all[0], own[0]), std::max(all[1], own[1]) };
  }
}

}

//------------------------------------------------------------------------------
Scene ReadScene(const RenderOptions& options, Progress& progress)
{
  Scene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();

  const bool smooth = options.ShadingKind != Shading::Flat;
  for (const std::string& path : options.Files)
  {
    const int before = scene.Renderer->GetActors()->GetNumberOfItems();
    if (IsModel(path))
    {
      scene.Models.push_back(ReadModel(path, options.Model, smooth, progress));
      WidenTimes(scene);
      for (const PosedModel::Part& part : scene.Models.back().Parts)
      {
        scene.Renderer->AddActor(part.Actor);
      }
      AddOwnLights(scene.Models.back(), scene.Renderer);
    }
    else
    {
      const vtkSmartPointer<vtkDataObject> surface = ReadSurface(path, smooth, progress);
      progress.Begin("preparing " + path);
      const auto parts = SplitByMaterials(surface, path, progress);
      for (vtkActor* actor : parts)
      {
        scene.Renderer->AddActor(actor);
      }
      if (parts.empty())
      {
        scene.Renderer->AddActor(DrawSurface(surface));
      }
      progress.End();
    }
    vtkActorCollection* actors = scene.Renderer->GetActors();
    scene.Counts.push_back(actors->GetNumberOfItems() - before);
    bool shows = false;
    for (int i = before; i < actors->GetNumberOfItems(); ++i)
    {
      vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
      AddArrayNames(actor, scene.Arrays, scene.Placed);
      if (IsMapped(options))
      {
        AddTextureCoordinates(actor, options, path);
      }
      CheckReach(actor, path);
      shows = shows || vtkMath::AreBoundsInitialized(actor->GetBounds());
    }
    Messages::Check(
      path, !shows, shows ? "" : "holds nothing that can be drawn: " + WhyNothing(path));
  }
  return scene;
}

//------------------------------------------------------------------------------
void DressScene(Scene& scene, const RenderOptions& options)
{
  SetShading(scene.Renderer, options.ShadingKind);
  SetLook(scene, options);
  for (const PosedModel& model : scene.Models)
  {
    if (model.Skeleton)
    {
      scene.Renderer->AddActor(model.Skeleton); // which looks as it does
    }
  }
  AddLights(scene.Renderer, options);
  CheckLights(scene.Renderer, options);
  PlaceCamera(scene.Renderer, options);
}

//------------------------------------------------------------------------------
void PlayScene(Scene& scene, const RenderOptions& options, double time, Progress& progress)
{
  for (PosedModel& model : scene.Models)
  {
    PlayModel(model, time, progress);
    for (const PosedModel::Part& part : model.Parts)
    {
      if (IsMapped(options))
      {
        AddTextureCoordinates(part.Actor, options, model.Path);
      }
      CheckReach(part.Actor, model.Path);
    }
  }
  if (!options.Clip)
  {
    scene.Renderer->ResetCameraClippingRange();
  }
}

//------------------------------------------------------------------------------
void FitTimes(Scene& scene, const RenderOptions& options, Progress& progress)
{
  progress.Begin("fitting the camera");
  const std::vector<double>& times = options.Model.Times;
  vtkBoundingBox box;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    PlayScene(scene, options, times[i], progress);
    box.AddBounds(scene.Renderer->ComputeVisiblePropBounds());
    progress.Update(static_cast<double>(i + 1) / static_cast<double>(times.size()));
  }
  progress.End();
  double bounds[6];
  box.GetBounds(bounds);
  const double scale = scene.Renderer->GetActiveCamera()->GetParallelScale();
  scene.Renderer->ResetCamera(bounds);
  if (options.ParallelScale)
  {
    scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
  }
  PlayScene(scene, options, times.front(), progress);
}

//------------------------------------------------------------------------------
CameraPlace GetPlace(vtkCamera* camera)
{
  const auto three = [](const double* values) {
    return std::array<double, 3>{ values[0], values[1], values[2] };
  };
  return { three(camera->GetPosition()), three(camera->GetFocalPoint()),
    three(camera->GetViewUp()) };
}
}
