// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "CameraPlace.h"
#include "Errors.h"
#include "ShadowOptions.h"
#include "Shadows.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoLampsStage.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <exception>

namespace viewer
{
namespace
{
constexpr const char* Reading[] = { "--time", "--times", "--animation", "--blend", "--loop",
  "--skeleton", "--bone-weight", "--skin", "--normal-map", "--height-map", "--texture-coordinates",
  "--up" };
constexpr const char* OfPoints[] = { "--lamps", "--fog", "--markers" };
constexpr const char* Wearing[] = { "--normal-map", "--height-map", "--relief",
  "--texture-coordinates", "--environment", "--reflectivity", "--skybox", "--up" };
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

std::string MakeSurfaceKey(const Settings& settings, const cli::RenderOptions& options)
{
  const bool shadowed = !options.HeightMap.empty() && cli::ShowsShadows(options);
  return MakeKey(settings, Wearing) + (shadowed ? "in its own shadow" : "");
}

// Everything but stages, the camera and the files.
std::string MakeDressKey(const Settings& settings)
{
  std::vector<const char*> names;
  const std::vector<cli::KnownOption> known = cli::GetRenderOptions();
  for (const cli::KnownOption& option : known)
  {
    const auto is = [&option](const char* name) { return option.Name == name; };
    if (std::none_of(std::begin(NoDress), std::end(NoDress), is))
    {
      names.push_back(option.Name.c_str());
    }
  }
  return MakeKey(settings, names);
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
  return GetSceneKey(settings) + MakeKey(settings, OfPoints);
}

//------------------------------------------------------------------------------
Picture::Picture(vtkRenderWindow* window)
  : Window(window)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<Picture*>(self)->FitClipping();
  });
  this->Observer = window->AddObserver(vtkCommand::StartEvent, command);
}

//------------------------------------------------------------------------------
Picture::~Picture()
{
  this->Window->RemoveObserver(this->Observer);
  this->Clear();
}

//------------------------------------------------------------------------------
void Picture::Remove(const Contents& contents)
{
  if (contents.Renderer)
  {
    vtkRelievoPass::Detach(contents.Renderer);
    this->Window->RemoveRenderer(contents.Renderer);
  }
}

//------------------------------------------------------------------------------
void Picture::Clear()
{
  this->Remove(this->Now);
  this->Now = Contents();
}

//------------------------------------------------------------------------------
void Picture::CheckShown(const std::string& what) const
{
  if (this->IsEmpty())
  {
    throw cli::WorkError(what + ": nothing is shown; open a file first");
  }
}

//------------------------------------------------------------------------------
vtkRelievoPass* Picture::GetFrame()
{
  return this->Now.Renderer ? vtkRelievoPass::SafeDownCast(this->Now.Renderer->GetPass()) : nullptr;
}

//------------------------------------------------------------------------------
void Picture::Show(const cli::Scene& scene, const cli::FramePoints& points,
  const Settings& settings, bool keepCamera)
{
  const Contents before = this->Now;
  const bool keep = keepCamera && before.Renderer;
  this->Now = Contents();
  this->Now.Bare = BareScene(scene);
  this->Now.Points = points;
  this->Now.Renderer = this->Now.Bare.Get().Renderer;
  this->Window->AddRenderer(this->Now.Renderer);
  if (keep)
  {
    this->Now.Renderer->GetActiveCamera()->DeepCopy(before.Renderer->GetActiveCamera());
  }
  try
  {
    this->Apply(settings, keep);
  }
  catch (...)
  {
    this->Remove(this->Now);
    this->Now = before;
    throw;
  }
  this->Remove(before);
}

//------------------------------------------------------------------------------
void Picture::ShowPoints(const cli::FramePoints& points, const Settings& settings)
{
  const cli::FramePoints before = this->Now.Points;
  this->Now.Points = points;
  vtkRelievoPass::Detach(this->Now.Renderer); // a new one takes them
  try
  {
    this->Update(settings);
  }
  catch (...)
  {
    this->Now.Points = before;
    vtkRelievoPass::Detach(this->Now.Renderer);
    this->SetFrame(this->Now.Options);
    throw;
  }
}

//------------------------------------------------------------------------------
bool Picture::IsDressedAlike(const Settings& settings) const
{
  return MakeSurfaceKey(settings, settings.Parse()) == this->Now.Surface;
}

//------------------------------------------------------------------------------
void Picture::Update(const Settings& settings)
{
  const Settings before = this->Now.Shown;
  try
  {
    this->Apply(settings, true);
  }
  catch (...)
  {
    this->Now.Dress = "\n";
    try
    {
      this->Apply(before, true);
    }
    catch (const std::exception&) // what was asked for is the trouble to tell of
    {
    }
    throw;
  }
}

//------------------------------------------------------------------------------
void Picture::Apply(const Settings& settings, bool keepCamera)
{
  cli::RenderOptions options = settings.Parse();
  if (keepCamera)
  {
    vtkCamera* camera = this->Now.Renderer->GetActiveCamera();
    options.Camera = GetPlace(camera);
    options.ParallelScale.reset();
    if (camera->GetParallelProjection())
    {
      options.ParallelScale = camera->GetParallelScale();
      options.ViewAngle.reset();
    }
  }
  const std::string surface = MakeSurfaceKey(settings, options);
  const std::string dress = MakeDressKey(settings);
  const bool wears = surface != this->Now.Surface;
  const bool bar = options.Look.ScalarBar && !this->IsBarFitted();
  if (wears || bar || dress != this->Now.Dress)
  {
    this->Now.Dress = "\n";
    this->Now.Renderer->GetActiveCamera()->SetViewAngle(StandardViewAngle);
    cli::DressScene(this->Now.Bare.Undress(), options);
    this->Now.Renderer->ComputeVisiblePropBounds(this->Now.Bounds);
    std::copy_n(this->Window->GetSize(), 2, this->Now.BarSize.begin());
  }
  if (wears)
  {
    this->Now.Bare.Wear(options);
  }
  this->Now.Surface = surface;
  this->Now.Dress = dress;
  this->SetFrame(options);
  this->Now.Options = options;
  this->Now.Shown = settings;
}

//------------------------------------------------------------------------------
bool Picture::IsBarFitted() const
{
  return std::equal(this->Now.BarSize.begin(), this->Now.BarSize.end(), this->Window->GetSize());
}

//------------------------------------------------------------------------------
// Stages that stay as they were keep what they hold.
void Picture::SetFrame(const cli::RenderOptions& options)
{
  if (!cli::NeedsFrame(options))
  {
    vtkRelievoPass::Detach(this->Now.Renderer);
    return;
  }
  vtkNew<vtkRelievoPass> wanted;
  cli::SetFrame(wanted, this->Now.Renderer, options, cli::FramePoints());
  if (options.ColoredShadows != this->Now.Options.ColoredShadows)
  {
    vtkRelievoPass::Detach(this->Now.Renderer); // for it says of props that they cast
  }
  const bool isNew = !this->GetFrame();
  vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Now.Renderer);
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
  cli::SetCasters(frame, this->Now.Renderer, options);
  if (isNew)
  {
    cli::AddFramePoints(frame, options, this->Now.Points);
  }
}

//------------------------------------------------------------------------------
// Fits the scalar bar and the clipping range before each frame, as the command line does.
void Picture::FitClipping()
{
  if (!this->Now.Renderer)
  {
    return;
  }
  if (this->Now.Options.Look.ScalarBar && !this->IsBarFitted())
  {
    try
    {
      this->Apply(Settings(this->Now.Shown), true);
    }
    catch (const std::exception&) // within a frame there is nobody to tell; it worked before
    {
    }
  }
  if (this->Now.Options.Clip)
  {
    this->Now.Renderer->GetActiveCamera()->SetClippingRange(this->Now.Options.Clip->data());
  }
  else
  {
    this->Now.Renderer->ResetCameraClippingRange(this->Now.Bounds);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Picture::Grab()
{
  vtkRelievoPass* frame = this->GetFrame();
  if (frame)
  {
    frame->WaitForSamplesOn();
  }
  this->Window->Render();
  if (frame)
  {
    frame->WaitForSamplesOff();
  }
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  return grab->GetOutput();
}
}
