// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Actors.h"
#include "Errors.h"
#include "FinitePoints.h"
#include "FittedView.h"
#include "Ground.h"
#include "Lights.h"
#include "Look.h"
#include "Models.h"
#include "Numbers.h"
#include "ObjMaterials.h"
#include "Options.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"
#include "TextureCoordinates.h"
#include "UpAxis.h"
#include "VolumeImages.h"

#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoAnnotation.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerLegend.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoScaleBar.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <cmath>

namespace scene
{
namespace
{
// Why reading dropped all content, from the file's notes.
std::string WhyNothing(const std::string& path, ReadContext& context)
{
  std::string why;
  for (const std::string& note : context.TakeNotes())
  {
    if (note.rfind(path + ": ", 0) == 0)
    {
      why += (why.empty() ? "" : "; ") + note.substr(path.size() + 2);
    }
  }
  return why.empty() ? "no points, or no cells" : why;
}

}

namespace
{
//------------------------------------------------------------------------------
// Radiance from a white surface in the scene's centre that faces one of the files' lights, which
// are in lux and candela; white is 1.
double FindBrightness(const Scene& scene, Shading shading)
{
  const vtkBoundingBox box(scene.Bounds);
  if (!box.IsValid())
  {
    return 0.0;
  }
  double center[3];
  box.GetCenter(center);
  const double nearest = 0.25 * box.GetDiagonalLength(); // least distance of a lamp
  std::vector<std::array<double, 3>> all; // directions to lights, scaled by brightness
  for (const PosedModel& model : scene.Models)
  {
    for (int i = 0; i < model.Reader->GetNumberOfLights(); ++i)
    {
      vtkLight* light = model.Reader->GetLight(i);
      std::array<double, 3> towards;
      light->GetTransformedPosition(towards.data());
      double target[3];
      light->GetTransformedFocalPoint(target);
      vtkMath::Subtract(towards.data(), light->GetPositional() ? center : target, towards.data());
      const double distance = vtkMath::Normalize(towards.data());
      const double* color = light->GetDiffuseColor();
      const double divisor =
        light->GetPositional() ? std::pow(std::max(distance, nearest), 2.0) : 1.0;
      vtkMath::MultiplyScalar(
        towards.data(), light->GetIntensity() * *std::max_element(color, color + 3) / divisor);
      all.push_back(towards);
    }
  }
  double brightest = 0.0;
  for (const std::array<double, 3>& one : all)
  {
    double sum = 0.0;
    for (const std::array<double, 3>& other : all)
    {
      sum += std::max(0.0, vtkMath::Dot(one.data(), other.data()));
    }
    brightest = std::max(brightest, sum / std::max(vtkMath::Norm(one.data()), 1e-300));
  }
  // VTK's PBR shows a power of the light, and the frame decodes VTK's output as sRGB.
  const bool isPBR = shading == Shading::FromFile || shading == Shading::PBR;
  return relievo::f64::relievoLinearFromSrgb(
    isPBR ? std::pow(brightest / vtkMath::Pi(), 1.0 / 2.2) : brightest);
}

//------------------------------------------------------------------------------
// The exposure, in stops, at which the files' lights show white as white. None if the options set
// an exposure, or if nothing is brighter than white.
std::optional<double> FindExposure(const Scene& scene, const RenderOptions& options)
{
  const auto exposes = [](const StageChoice& stage) {
    return stage.Name == "tone" &&
      std::any_of(stage.Parameters.begin(), stage.Parameters.end(),
        [](const auto& each) { return each.first == "exposure" || each.first == "auto_exposure"; });
  };
  if (!options.YieldsToFile || !scene.HasLights || options.Has("--certify") ||
    std::any_of(options.Stages.begin(), options.Stages.end(), exposes))
  {
    return std::nullopt;
  }
  const double stops = -std::log2(std::max(FindBrightness(scene, options.ShadingKind), 1.0));
  return stops < 0.0 ? std::optional<double>(std::max(stops, -20.0)) : std::nullopt;
}
}

//------------------------------------------------------------------------------
RenderOptions FollowFile(RenderOptions options, const Scene& scene)
{
  if (options.FindsUp)
  {
    options.UpAxis = scene.UpAxis;
  }
  if (options.YieldsToFile && scene.HasLights)
  {
    options.Lights.clear();
    if (const std::optional<double> stops = FindExposure(scene, options))
    {
      const bool isToned = std::any_of(options.Stages.begin(), options.Stages.end(),
        [](const StageChoice& stage) { return stage.Name == "tone"; });
      auto& parameters = AddStage(options.Stages, "tone", "--preset").Parameters;
      parameters.emplace_back("exposure", WriteNumber(*stops));
      if (!isToned)
      {
        parameters.emplace_back("operator", "clamp"); // white stays white
      }
    }
  }
  return options;
}

namespace
{
//------------------------------------------------------------------------------
// The lights follow the reader's time.
void AddOwnLights(const PosedModel& model, vtkRenderer* renderer)
{
  for (int i = 0; i < model.Reader->GetNumberOfLights(); ++i)
  {
    renderer->AddLight(model.Reader->GetLight(i));
  }
}

//------------------------------------------------------------------------------
// Returns the surfaces to draw; null if the renderer has a volume instead.
vtkSmartPointer<vtkDataObject> ShowImage(vtkImageData* image, const ImageChoice& choice,
  vtkRenderer* renderer, const std::string& path, ReadContext& context)
{
  using Kind = ImageChoice::Kind;
  const bool found = choice.Is == Kind::Found;
  if (choice.Is == Kind::Volume)
  {
    renderer->AddVolume(MakeVolume(image));
    return nullptr;
  }
  if (choice.Is == Kind::Labels || (found && HasLabels(image)))
  {
    if (found)
    {
      context.Note(
        path + ": holds labels, shown by their surfaces; --image volume shows them as a volume");
    }
    const std::string error = found ? "" : CheckLabels(image);
    if (!error.empty())
    {
      throw WorkError(path + ": --image labels: " + error +
        "; --image surface shows where one is reached, --image volume all of them");
    }
    return MakeLabelSurfaces(image, context.GetProgress());
  }
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range);
  if (found && !(range[0] < range[1])) // no value separates the samples
  {
    return image;
  }
  const double value = choice.Value ? *choice.Value : FindThreshold(image);
  if (!(range[0] < value && value <= range[1]))
  {
    throw WorkError(path + ": --image surface: got " + WriteNumber(value) +
      ", expected a value above " + WriteNumber(range[0]) + " and not above " +
      WriteNumber(range[1]));
  }
  if (found)
  {
    context.Note(path + ": shown by the surface where its values are " + WriteNumber(value) +
      "; --image volume shows all of them, --image box the outer faces");
  }
  return MakeIsosurface(image, value, context.GetProgress());
}

//------------------------------------------------------------------------------
// Notes that a requested --image has no effect on the data.
void NoteIdleImage(
  vtkDataObject* data, const RenderOptions& options, const std::string& path, ReadContext& context)
{
  using Kind = ImageChoice::Kind;
  const std::string extension = ExtensionOf(path);
  const bool asked = options.Image.Is != Kind::Found && options.Image.Is != Kind::Box;
  const bool concerns =
    extension == ".vti" || extension == ".pvti" || options.Files.size() == 1; // not a mesh beside
  if (asked && concerns && !vtkImageData::SafeDownCast(data))
  {
    context.Note(path +
      ": --image changed nothing: it shows images with depth and one value for each point or cell");
  }
}

//------------------------------------------------------------------------------
// Widens the scene's times by the last model's animation.
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
Scene ReadScene(const RenderOptions& options, ReadContext& context)
{
  Progress& progress = context.GetProgress();
  Scene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  RenderOptions known = options;

  const bool smooth = options.ShadingKind != Shading::Flat;
  for (const std::string& path : options.Files)
  {
    const int before = scene.Renderer->GetActors()->GetNumberOfItems();
    const int volumes = scene.Renderer->GetVolumes()->GetNumberOfItems();
    if (IsModel(path))
    {
      scene.Models.push_back(ReadModel(path, options.Model, smooth, context));
      WidenTimes(scene);
      for (const PosedModel::Part& part : scene.Models.back().Parts)
      {
        scene.Renderer->AddActor(part.Actor);
      }
      AddOwnLights(scene.Models.back(), scene.Renderer);
      scene.HasLights = scene.Renderer->GetLights()->GetNumberOfItems() > 0;
    }
    else
    {
      scene.Dimensions.resize(scene.Counts.size() + 1);
      const bool images = options.Image.Is != ImageChoice::Kind::Box;
      vtkSmartPointer<vtkDataObject> surface = ReadSurface(path, smooth, images, context);
      progress.Begin("preparing " + path);
      NoteIdleImage(surface, options, path, context);
      if (auto* image = vtkImageData::SafeDownCast(surface))
      {
        image->GetDimensions(scene.Dimensions.back().data());
        surface = ShowImage(image, options.Image, scene.Renderer, path, context);
        surface = surface ? MakeSurface(surface, smooth, path, context) : nullptr;
      }
      auto parts = surface ? SplitByMaterials(surface, path, context)
                           : std::vector<vtkSmartPointer<vtkActor>>();
      if (parts.empty() && surface)
      {
        parts = DrawTextured(surface, path, context);
      }
      for (vtkActor* actor : parts)
      {
        scene.Renderer->AddActor(actor);
      }
      if (parts.empty() && surface)
      {
        scene.Renderer->AddActor(DrawSurface(surface));
      }
      progress.End();
    }
    vtkActorCollection* actors = scene.Renderer->GetActors();
    scene.Counts.push_back(actors->GetNumberOfItems() - before);
    scene.Dimensions.resize(scene.Counts.size());
    bool shows = scene.Renderer->GetVolumes()->GetNumberOfItems() > volumes;
    if (&path == &options.Files.front())
    {
      scene.UpAxis = FindUpAxis(path, scene.Renderer->ComputeVisiblePropBounds());
      known = FollowFile(options, scene);
    }
    for (int i = before; i < actors->GetNumberOfItems(); ++i)
    {
      vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
      AddArrayNames(actor, scene.Arrays);
      if (options.Surface.IsMapped())
      {
        AddTextureCoordinates(actor, known.Surface.TextureMapping, known.UpAxis, path, context);
      }
      CheckReach(actor, path);
      shows = shows || vtkMath::AreBoundsInitialized(actor->GetBounds());
    }
    context.Check(
      path, !shows, shows ? "" : "contains nothing to draw: " + WhyNothing(path, context));
  }
  scene.Renderer->ComputeVisiblePropBounds(scene.Bounds);
  if (const std::optional<double> stops = FindExposure(scene, options))
  {
    context.Note("the files' lights, in lux and candela, are brighter than white: drawn with "
                 "--exposure " +
      WriteNumber(std::round(100.0 * *stops) / 100.0) +
      ", which darkens the background too; give --exposure to choose it");
  }
  return scene;
}

namespace
{
//------------------------------------------------------------------------------
// Lays a ground below the scene's bounds and removes the previous one.
void LayGround(Scene& scene, const RenderOptions& options)
{
  scene.Renderer->RemoveActor(scene.Ground);
  scene.Ground = nullptr;
  if (options.Ground.value_or(false) && vtkMath::AreBoundsInitialized(scene.Bounds) &&
    !FittedView::IsFlat(scene.Bounds))
  {
    // Moving models would leave the darkness of their first moment behind; the stage `ambient`
    // darkens the ground itself.
    const bool hasContact = !scene.Times && !DarkensByRays(options.Stages);
    scene.Ground = MakeGround(scene.Bounds, options.UpAxis,
      options.Look.Background.empty() ? Color{} : options.Look.Background.front(),
      hasContact ? scene.Renderer.Get() : nullptr);
    scene.Renderer->AddActor(scene.Ground);
  }
}

//------------------------------------------------------------------------------
// Lays a grid around the scene's bounds and removes the previous one.
void LayGrid(Scene& scene, const RenderOptions& options)
{
  if (scene.Grid)
  {
    scene.Grid->Remove(scene.Renderer);
    scene.Grid = nullptr;
  }
  if (options.Look.Grid && vtkMath::AreBoundsInitialized(scene.Bounds))
  {
    scene.Grid = Grid::Add(scene.Renderer, scene.Bounds, options.UpAxis, options.Look.Print);
  }
}
}

//------------------------------------------------------------------------------
void StyleScene(Scene& scene, const RenderOptions& options)
{
  SetShading(scene.Renderer, options.ShadingKind);
  // A layer shown as the picture hides the colours of values: the bar is that of the layer.
  const std::string* layer = FindStageChoice(options.Stages, "display", "layer");
  LookChoice look = options.Look;
  const bool isLegend = look.ScalarBar && layer && !layer->empty();
  look.ScalarBar = look.ScalarBar && !isLegend;
  SetLook(scene.Renderer, look, scene.Arrays, options.Surface.IsMapped());
  if (isLegend)
  {
    vtkNew<vtkRelievoLayerLegend> legend;
    legend->SetPlace(look.Bar.Place);
    legend->SetTextSize(look.Print.GetTextSize());
    scene.Renderer->AddViewProp(legend);
  }
  for (const PosedModel& model : scene.Models)
  {
    if (model.Skeleton)
    {
      scene.Renderer->AddActor(model.Skeleton); // keeps its own look
    }
  }
  AddLights(scene.Renderer, options.Lights, options.UpAxis, !options.Surface.Environment.empty());
  CheckLights(scene.Renderer, options.Lights);
  scene.Renderer->ComputeVisiblePropBounds(scene.Bounds);
  LayGround(scene, options);
  LayGrid(scene, options);
  if (options.Look.ScaleBar)
  {
    vtkNew<vtkRelievoScaleBar> bar;
    bar->SetUnit(*options.Look.ScaleBar);
    bar->SetLength(options.Look.ScaleBarLength);
    bar->SetTextSize(options.Look.Print.GetTextSize());
    // Other backgrounds are painted for --transparent; the ink must not follow them.
    bar->SetInk(vtkRelievoAnnotation::GetInk(scene.Renderer)[0] < 0.5
        ? vtkRelievoScaleBar::INK_BLACK
        : vtkRelievoScaleBar::INK_WHITE);
    scene.Renderer->AddViewProp(bar);
  }
  PlaceCamera(scene.Renderer, options.View, options.UpAxis, scene.Bounds);
}

//------------------------------------------------------------------------------
void PlayScene(Scene& scene, const RenderOptions& options, double time, Progress& progress)
{
  ReadContext context(progress);
  for (PosedModel& model : scene.Models)
  {
    PlayModel(model, time, context);
    for (const PosedModel::Part& part : model.Parts)
    {
      if (options.Surface.IsMapped())
      {
        AddTextureCoordinates(
          part.Actor, options.Surface.TextureMapping, options.UpAxis, model.Path, context);
      }
      CheckReach(part.Actor, model.Path);
    }
  }
  if (!options.View.Clip)
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
  scene.Renderer->RemoveActor(scene.Ground);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    PlayScene(scene, options, times[i], progress);
    box.AddBounds(scene.Renderer->ComputeVisiblePropBounds());
    progress.Update(static_cast<double>(i + 1) / static_cast<double>(times.size()));
  }
  progress.End();
  box.GetBounds(scene.Bounds);
  LayGround(scene, options);
  LayGrid(scene, options);
  PlaceCamera(scene.Renderer, options.View, options.UpAxis, scene.Bounds);
  PlayScene(scene, options, times.front(), progress);
}
}
