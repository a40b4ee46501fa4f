// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture's camera: how the user moves it, and its words.
#include "CameraPlace.h"

#include "Picture.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <array>
#include <cmath>

namespace viewer
{
namespace
{
std::array<double, 3> Three(const double* values)
{
  return { values[0], values[1], values[2] };
}
}

//------------------------------------------------------------------------------
cli::CameraPlace GetPlace(vtkCamera* camera)
{
  return { Three(camera->GetPosition()), Three(camera->GetFocalPoint()),
    Three(camera->GetViewUp()) };
}

//------------------------------------------------------------------------------
void Picture::ResetCamera()
{
  if (this->Now.Renderer)
  {
    this->Now.Renderer->ResetCamera(this->Now.Bounds);
  }
}

//------------------------------------------------------------------------------
void Picture::LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up)
{
  if (this->Now.Renderer)
  {
    vtkCamera* camera = this->Now.Renderer->GetActiveCamera();
    const std::array<double, 3> at = GetPlace(camera).FocalPoint;
    camera->SetPosition(at[0] - direction[0], at[1] - direction[1], at[2] - direction[2]);
    camera->SetViewUp(up.data());
    this->ResetCamera();
  }
}

//------------------------------------------------------------------------------
void Picture::SetParallel(bool on)
{
  if (this->Now.Renderer)
  {
    vtkCamera* camera = this->Now.Renderer->GetActiveCamera();
    if (on == (camera->GetParallelProjection() != 0))
    {
      return;
    }
    if (!on)
    {
      // A parallel picture has no angle of its own.
      camera->SetViewAngle(this->Now.Shown.Parse().ViewAngle.value_or(StandardViewAngle));
    }
    const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    if (on)
    {
      camera->SetParallelScale(camera->GetDistance() * half);
    }
    else
    {
      camera->Dolly(camera->GetDistance() * half / camera->GetParallelScale());
    }
    camera->SetParallelProjection(on);
  }
}

//------------------------------------------------------------------------------
bool Picture::IsParallel() const
{
  return this->Now.Renderer && this->Now.Renderer->GetActiveCamera()->GetParallelProjection();
}

//------------------------------------------------------------------------------
Settings Picture::GetView(const Settings& settings) const
{
  Settings view = settings;
  if (this->Now.Renderer)
  {
    const int* size = this->Window->GetSize();
    view.Set("--size", std::to_string(size[0]) + "x" + std::to_string(size[1]));
    vtkCamera* camera = this->Now.Renderer->GetActiveCamera();
    const cli::CameraPlace place = GetPlace(camera);
    std::vector<double> numbers;
    for (const std::array<double, 3>& each : { place.Position, place.FocalPoint, place.ViewUp })
    {
      numbers.insert(numbers.end(), each.begin(), each.end());
    }
    view.Set("--camera", WriteNumbers(numbers));
    view.Remove("--parallel-scale");
    if (camera->GetParallelProjection())
    {
      view.Set("--parallel-scale", WriteNumber(camera->GetParallelScale()));
      view.Remove("--view-angle");
    }
  }
  return view;
}
}
