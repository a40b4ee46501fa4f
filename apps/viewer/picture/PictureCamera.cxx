// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture's camera: how the user moves it, and its words.
#include "Picture.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>

namespace viewer
{
//------------------------------------------------------------------------------
void Picture::ResetCamera()
{
  if (this->GetRenderer())
  {
    this->GetRenderer()->ResetCamera(this->Now.Scene.GetBounds());
  }
}

//------------------------------------------------------------------------------
void Picture::LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    const std::array<double, 3> at = scene::GetPlace(camera).FocalPoint;
    camera->SetPosition(at[0] - direction[0], at[1] - direction[1], at[2] - direction[2]);
    camera->SetViewUp(up.data());
    this->ResetCamera();
  }
}

//------------------------------------------------------------------------------
void Picture::SetParallel(bool on)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    if (on == (camera->GetParallelProjection() != 0))
    {
      return;
    }
    if (!on)
    {
      // A parallel picture has no angle of its own.
      camera->SetViewAngle(this->Now.Shown.Parse().ViewAngle.value_or(scene::StandardViewAngle));
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
  return this->GetRenderer() && this->GetRenderer()->GetActiveCamera()->GetParallelProjection();
}

//------------------------------------------------------------------------------
scene::Settings Picture::GetView(const scene::Settings& settings) const
{
  scene::Settings view = settings;
  if (this->GetRenderer())
  {
    const int* size = this->Window->GetSize();
    view.Set("--size", std::to_string(size[0]) + "x" + std::to_string(size[1]));
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    const scene::CameraPlace place = scene::GetPlace(camera);
    std::vector<double> numbers;
    for (const std::array<double, 3>& each : { place.Position, place.FocalPoint, place.ViewUp })
    {
      numbers.insert(numbers.end(), each.begin(), each.end());
    }
    view.Set("--camera", scene::WriteNumbers(numbers));
    view.Remove("--parallel-scale");
    if (camera->GetParallelProjection())
    {
      view.Set("--parallel-scale", scene::WriteNumber(camera->GetParallelScale()));
      view.Remove("--view-angle");
    }
  }
  return view;
}
}
