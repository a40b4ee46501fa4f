// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoEnvironment.h"

#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoClamped.h"
#include "vtkPVRelievoMaterial.h"
#include "vtkPropCollection.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoMaterial.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <vector>

namespace
{
// Tolerance of levels for rough mirrors, as in the command: takes a third of the filter's default
// time.
constexpr double LevelTolerance = 2e-3;

// The compositor of several processes, or nullptr.
vtkSynchronizedRenderers* FindCompositor(vtkPVRenderView* view)
{
  auto* ranks = vtkPVRelievoAccess::View::Passes(view)->GetParallelSynchronizer();
  vtkMultiProcessController* controller = ranks ? ranks->GetParallelController() : nullptr;
  return controller && controller->GetNumberOfProcesses() > 1 && ranks->GetParallelRendering()
    ? ranks
    : nullptr;
}
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkRelievoEnvironmentLight> vtkPVRelievoEnvironment::Read(
  vtkObject* self, const std::string& path)
{
  std::string failure;
  const vtkSmartPointer<vtkImageData> image = vtkRelievoImageFile::Read(path, failure);
  vtkRelievoEnvironmentLight made;
  if (image)
  {
    made.SetImage(image, failure);
  }
  if (!failure.empty())
  {
    if (vtkPVRelievoReports())
    {
      vtkErrorWithObjectMacro(self,
        "RelievoEnvironment was given '" << path << "', expected " << failure
                                         << ". There is no environment.");
    }
    return nullptr;
  }
  static std::map<vtkImageData*, std::weak_ptr<vtkRelievoEnvironmentLight>> all;
  std::shared_ptr<vtkRelievoEnvironmentLight> light = all[image].lock();
  if (!light)
  {
    light = std::make_shared<vtkRelievoEnvironmentLight>(made);
    all[image] = light;
  }
  return light;
}

//------------------------------------------------------------------------------
void vtkPVRelievoEnvironment::SetFile(const char* file)
{
  const std::string path = file ? file : "";
  if (path != this->Path)
  {
    this->Path = path;
    this->HasRead = false;
    this->Content = nullptr;
    this->Environment->SetImage(nullptr);
    this->Environment->SetLevels(nullptr);
    this->Environment->SetIrradiance(nullptr);
  }
}

//------------------------------------------------------------------------------
bool vtkPVRelievoEnvironment::Ready(vtkObject* self, bool mirrored, bool rough)
{
  if (this->Path.empty())
  {
    return false;
  }
  if (!this->HasRead)
  {
    this->HasRead = true;
    this->Content = Read(self, this->Path);
  }
  if (!this->Content)
  {
    return false;
  }
  if (mirrored)
  {
    this->Content->MakeIrradiance();
  }
  if (rough)
  {
    this->Content->MakeLevels(LevelTolerance);
  }
  this->Environment->SetSRGB(this->Content->SRGB);
  this->Environment->SetImage(this->Content->Image);
  this->Environment->SetLevels(this->Content->Levels);
  this->Environment->SetIrradiance(this->Content->Irradiance);
  return true;
}

//------------------------------------------------------------------------------
void vtkPVRelievoEnvironment::Prepare(vtkObject* self, vtkPVRenderView* view)
{
  const bool mirrored = vtkPVRelievoMaterial::IsMirrored(view);
  const bool ready = (mirrored || this->Sky) && !vtkPVRelievoAccess::View::IsDrawnElsewhere(view) &&
    this->Ready(self, mirrored, vtkPVRelievoMaterial::IsMirrored(view, true));
  vtkPVRelievoMaterial::Prepare(view, ready ? this->Environment.Get() : nullptr);
  this->Skybox->SetEnvironment(ready && this->Sky ? this->Environment.Get() : nullptr);
  vtkRenderer* renderer = view->GetRenderer();
  this->Darkness.Place(renderer, ready && mirrored);
  const bool wanted = this->Skybox->GetEnvironment() && !FindCompositor(view);
  if (wanted && !renderer->HasViewProp(this->Skybox))
  {
    renderer->AddViewProp(this->Skybox);
  }
  else if (!wanted)
  {
    renderer->RemoveViewProp(this->Skybox);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoEnvironment::Finish(vtkPVRenderView* view)
{
  vtkRelievoMaterial::ReleaseTextureUnits(); // ParaView's windows share their OpenGL state
  vtkSynchronizedRenderers* ranks = FindCompositor(view);
  vtkRenderer* renderer = view->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Skybox->GetEnvironment() || !ranks || !window || renderer->GetSelector() ||
    ranks->GetParallelController()->GetLocalProcessId() != 0)
  {
    return;
  }
  auto& whole = vtkPVRelievoAccess::Synchronizer::Capture(ranks);
  vtkUnsignedCharArray* colors = whole.GetRawPtr();
  if (!whole.IsValid() || colors->GetNumberOfComponents() != 4)
  {
    return;
  }
  // The window's framebuffer is free: the composited picture replaces it next.
  const int width = whole.GetWidth();
  const int height = whole.GetHeight();
  std::vector<unsigned char> sky(static_cast<std::size_t>(width) * height * 4);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  this->Skybox->RenderOpaqueGeometry(renderer);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, sky.data());
  unsigned char* color = colors->GetPointer(0);
  for (std::size_t i = 0; i < sky.size(); i += 4)
  {
    const int behind = 255 - color[i + 3]; // colours are premultiplied by opacity
    for (std::size_t j = i; j < i + 3; ++j)
    {
      color[j] =
        static_cast<unsigned char>(std::min(255, color[j] + (behind * sky[j] + 127) / 255));
    }
    color[i + 3] = 255;
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoEnvironment::Leave(vtkPVRenderView* view)
{
  view->GetRenderer()->RemoveViewProp(this->Skybox);
  this->Darkness.Place(view->GetRenderer(), false);
  vtkPVRelievoMaterial::Forget(this->Environment);
}
