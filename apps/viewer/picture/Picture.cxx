// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Baseline.h"
#include "Errors.h"
#include "Progress.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <exception>

namespace viewer
{
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
  if (vtkRenderer* renderer = contents.Scene.GetRenderer())
  {
    vtkRelievoPass::Detach(renderer);
    this->Window->RemoveRenderer(renderer);
  }
}

//------------------------------------------------------------------------------
void Picture::Clear()
{
  this->Remove(this->Now);
  this->Now = Contents();
}

//------------------------------------------------------------------------------
bool Picture::HasVolume() const
{
  return !this->IsEmpty() && this->GetRenderer()->GetVolumes()->GetNumberOfItems() > 0;
}

//------------------------------------------------------------------------------
void Picture::CheckShown(const std::string& what) const
{
  if (this->IsEmpty())
  {
    throw words::WorkError(what + ": nothing is shown; open a file first");
  }
}

//------------------------------------------------------------------------------
void Picture::ApplyStyle(const scene::Settings& settings, bool keepCamera)
{
  reading::Progress progress(this->Listener);
  this->Now.Scene.Update(settings, settings.Parse(), keepCamera, progress);
}

//------------------------------------------------------------------------------
void Picture::Show(const scene::Scene& scene, const scene::FramePoints& points,
  const scene::Settings& settings, bool keepCamera)
{
  const Contents before = this->Now;
  vtkRenderer* shown = before.Scene.GetRenderer();
  const bool keep = keepCamera && shown;
  this->Now = { scene::StyledScene(scene, points), {} };
  this->Window->AddRenderer(this->GetRenderer());
  if (keep)
  {
    this->GetRenderer()->GetActiveCamera()->DeepCopy(shown->GetActiveCamera());
  }
  try
  {
    this->ApplyStyle(settings, keep);
    this->Now.Shown = settings;
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
void Picture::ShowPoints(const scene::FramePoints& points, const scene::Settings& settings)
{
  const scene::FramePoints before = this->Now.Scene.GetPoints();
  const scene::Settings shown = this->Now.Shown;
  this->Now.Scene.SetPoints(points);
  try
  {
    this->ApplyStyle(settings, true);
    this->Now.Shown = settings;
  }
  catch (...)
  {
    this->Now.Scene.SetPoints(before);
    this->ApplyStyle(shown, true);
    throw;
  }
}

//------------------------------------------------------------------------------
bool Picture::HasSurfaceOf(const scene::Settings& settings) const
{
  return this->Now.Scene.HasSurfaceOf(settings);
}

//------------------------------------------------------------------------------
void Picture::Update(const scene::Settings& settings)
{
  try
  {
    this->ApplyStyle(settings, true);
    this->Now.Shown = settings;
  }
  catch (...)
  {
    try
    {
      this->ApplyStyle(this->Now.Shown, true);
    }
    catch (const std::exception&) // the original error is reported instead
    {
    }
    throw;
  }
}

//------------------------------------------------------------------------------
// Fits the clipping range before each frame, like the command line.
void Picture::FitClipping()
{
  if (this->IsEmpty())
  {
    return;
  }
  scene::StyledScene& scene = this->Now.Scene;
  const look::CameraChoice& choice = this->Other ? *this->Other : scene.GetOptions().View;
  if (choice.Clip)
  {
    this->GetRenderer()->GetActiveCamera()->SetClippingRange(choice.Clip->data());
  }
  else
  {
    this->GetRenderer()->ResetCameraClippingRange();
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

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Picture::Capture(bool portable)
{
  scene::RenderOptions options = this->Now.Scene.GetOptions();
  std::copy_n(this->Window->GetSize(), 2, options.Size.begin());
  return scene::MakeBaseline(this->Now.Scene, options, this->Now.Shown, portable);
}
}
