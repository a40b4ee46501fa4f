// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DressedScene.h"

#include "Look.h"
#include "ShadowOptions.h"
#include "Shadows.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <vector>

namespace scene
{
namespace
{
constexpr const char* Reading[] = { "--allow-folder", "--time", "--times", "--animation", "--blend",
  "--loop", "--image", "--skeleton", "--bone-weight", "--skin", "--normal-map", "--height-map",
  "--texture-coordinates", "--up" };
constexpr const char* Wearing[] = { "--normal-map", "--height-map", "--relief", "--material",
  "--texture-coordinates", "--opacity", "--environment", "--reflectivity", "--skybox", "--up" };
constexpr const char* NoDress[] = { "--camera", "--clip", "--size", "--shadows" };

template <typename Names>
std::string MakeKey(const Settings& settings, const Names& names)
{
  std::string key;
  for (const char* name : names)
  {
    for (const std::string& value : settings.GetAll(name))
    {
      key += std::string(name) + '\n' + value + '\n';
    }
  }
  return key;
}

std::string MakeSurfaceKey(const Settings& settings, const RenderOptions& options)
{
  const bool shadowed = !options.HeightMap.empty() && ShowsShadows(options);
  return MakeKey(settings, Wearing) + (shadowed ? "in its own shadow" : "");
}

// The key of all options except those of the camera and of the shadow method.
std::string MakeDressKey(const Settings& settings)
{
  std::vector<const char*> names;
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    const auto is = [&option](const char* name) { return option.Name == name; };
    if (std::none_of(std::begin(NoDress), std::end(NoDress), is))
    {
      names.push_back(option.Name.c_str());
    }
  }
  return MakeKey(settings, names);
}

RenderOptions WithCamera(RenderOptions options, vtkCamera* camera)
{
  options.Camera = GetPlace(camera);
  options.ParallelScale.reset();
  if (camera->GetParallelProjection())
  {
    options.ParallelScale = camera->GetParallelScale();
    options.ViewAngle.reset();
  }
  return options;
}
}

//------------------------------------------------------------------------------
std::string GetSceneKey(const Settings& settings)
{
  std::string key = MakeKey(settings, Reading);
  key += settings.Get("--shading") == "flat" ? "flat\n" : "";
  for (const std::string& file : settings.Files)
  {
    key += file + '\n';
  }
  return key;
}

//------------------------------------------------------------------------------
std::string GetReadingKey(const Settings& settings)
{
  std::string key = GetSceneKey(settings);
  for (const PointStage& stage : GetPointStages())
  {
    const std::string option = "--" + stage.Name;
    key += MakeKey(settings, std::vector<const char*>{ option.c_str() });
  }
  return key;
}

//------------------------------------------------------------------------------
DressedScene::DressedScene(const Scene& scene, const FramePoints& points)
  : Bare(scene)
  , Points(points)
{
}

//------------------------------------------------------------------------------
vtkRelievoPass* DressedScene::GetFrame() const
{
  vtkRenderer* renderer = this->GetRenderer();
  return renderer ? vtkRelievoPass::SafeDownCast(renderer->GetPass()) : nullptr;
}

//------------------------------------------------------------------------------
void DressedScene::SetPoints(const FramePoints& points)
{
  this->Points = points;
  vtkRelievoPass::Detach(this->GetRenderer()); // a new frame takes the points
}

//------------------------------------------------------------------------------
bool DressedScene::IsDressedAlike(const Settings& settings) const
{
  return MakeSurfaceKey(settings, settings.Parse()) == this->Surface;
}

//------------------------------------------------------------------------------
bool DressedScene::IsBarOutgrown() const
{
  return this->Options.Look.ScalarBar &&
    !std::equal(this->BarSize.begin(), this->BarSize.end(),
      this->GetRenderer()->GetRenderWindow()->GetSize());
}

//------------------------------------------------------------------------------
void DressedScene::Update(
  const Settings& settings, const RenderOptions& asked, bool keepCamera, Progress& progress)
{
  vtkRenderer* renderer = this->GetRenderer();
  const RenderOptions known = FollowFile(asked, this->Bare.Get());
  const RenderOptions options = keepCamera ? WithCamera(known, renderer->GetActiveCamera()) : known;
  const std::string surface = MakeSurfaceKey(settings, options);
  const std::string dress = MakeDressKey(settings);
  const bool wears = surface != this->Surface;
  const bool isDressed = !wears && dress == this->Dress && !this->IsBarOutgrown();
  try
  {
    if (!isDressed)
    {
      renderer->GetActiveCamera()->SetViewAngle(StandardViewAngle);
      DressScene(this->Bare.Undress(), options);
      std::copy_n(renderer->GetRenderWindow()->GetSize(), 2, this->BarSize.begin());
    }
    else if (!keepCamera)
    {
      renderer->GetActiveCamera()->SetViewAngle(StandardViewAngle);
      PlaceCamera(renderer, options, this->GetBounds());
    }
    if (wears)
    {
      this->Bare.Wear(options, progress);
    }
    if (!isDressed || wears)
    {
      SetDepthPeeling(this->Bare.Get());
    }
    this->Surface = surface;
    this->Dress = dress;
    this->SetFrame(options);
  }
  catch (...)
  {
    this->Dress = "\n";
    throw;
  }
  this->Options = options;
}

//------------------------------------------------------------------------------
// Unchanged stages keep their resources.
void DressedScene::SetFrame(const RenderOptions& options)
{
  vtkRenderer* renderer = this->GetRenderer();
  if (!NeedsFrame(options))
  {
    vtkRelievoPass::Detach(renderer);
    return;
  }
  vtkNew<vtkRelievoPass> wanted;
  scene::SetFrame(wanted, renderer, options, FramePoints());
  const auto colors = [](const RenderOptions& of) {
    const std::string* given = FindStageChoice(of.Stages, "shadows", "colored_shadows");
    return given && *given == "on";
  };
  if (colors(options) != colors(this->Options))
  {
    vtkRelievoPass::Detach(renderer); // the frame marks props as casters
  }
  const bool isNew = !this->GetFrame();
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  for (int i = 0; i < wanted->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* from = wanted->GetStage(i);
    vtkRelievoStage* to = frame->GetStage(from->GetStageName());
    to->SetEnabled(from->GetEnabled());
    for (int k = 0; k < from->GetNumberOfParameters(); ++k)
    {
      const std::string name = from->GetParameterName(k);
      const std::string value = from->GetParameter(name);
      if (to->GetParameter(name) != value)
      {
        to->SetParameter(name, value);
      }
    }
  }
  SetCasters(frame, renderer, options);
  if (isNew)
  {
    AddFramePoints(frame, this->Points);
  }
}
}
