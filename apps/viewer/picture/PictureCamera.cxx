// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture's camera: the user's movements, and its words.
#include "Picture.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
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
Picture::Stand Picture::GetStand(double aspect) const
{
  vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
  return { look::GetPlace(camera), camera->GetParallelScale(), camera->GetViewAngle(), aspect };
}

//------------------------------------------------------------------------------
// The vertical angle stays, so that a narrower view would cut off both sides.
void Picture::KeepInView(double before, double now)
{
  const double* bounds = this->Now.Scene.GetBounds();
  if (!this->GetRenderer() || bounds[0] > bounds[1])
  {
    return;
  }
  const Stand stand = this->GetStand(before);
  if (stand.Place.Position != this->Fitted.Place.Position ||
    stand.Place.FocalPoint != this->Fitted.Place.FocalPoint ||
    stand.Place.ViewUp != this->Fitted.Place.ViewUp || stand.Scale != this->Fitted.Scale ||
    stand.Angle != this->Fitted.Angle)
  {
    this->Chosen = stand;
  }
  vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
  const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const std::array<double, 3>& from = this->Chosen.Place.Position;
  double along[3], up[3], right[3];
  camera->GetDirectionOfProjection(along);
  camera->GetViewUp(up);
  vtkMath::Cross(along, up, right);
  vtkMath::Normalize(right);
  double back = 0.0;
  double scale = this->Chosen.Scale;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double v[3] = { bounds[corner & 1] - from[0], bounds[2 + ((corner >> 1) & 1)] - from[1],
      bounds[4 + ((corner >> 2) & 1)] - from[2] };
    const double aside = std::abs(vtkMath::Dot(v, right));
    const double depth = vtkMath::Dot(v, along);
    // In half views: places outside may stay equally far outside.
    const double seen = this->Chosen.Aspect *
      (camera->GetParallelProjection() ? this->Chosen.Scale : half * std::max(depth, 0.0));
    const double most = std::max(1.0, aside / seen);
    scale = std::max(scale, aside / (now * most));
    back = depth > 0.0 ? std::max(back, aside / (half * now * most) - depth) : back;
  }
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(scale);
  }
  else
  {
    camera->SetPosition(
      from[0] - back * along[0], from[1] - back * along[1], from[2] - back * along[2]);
  }
  this->Fitted = this->GetStand(now);
}

//------------------------------------------------------------------------------
void Picture::LookAlong(const std::array<double, 3>& direction, const std::array<double, 3>& up)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    const std::array<double, 3> at = look::GetPlace(camera).FocalPoint;
    camera->SetPosition(at[0] - direction[0], at[1] - direction[1], at[2] - direction[2]);
    camera->SetViewUp(up.data());
    this->ResetCamera();
  }
}

//------------------------------------------------------------------------------
void Picture::Place(const look::CameraPlace& view)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    camera->SetPosition(view.Position.data());
    camera->SetFocalPoint(view.FocalPoint.data());
    camera->SetViewUp(view.ViewUp.data());
  }
}

//------------------------------------------------------------------------------
void Picture::Turn(double right, double up)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    camera->Azimuth(right);
    camera->Elevation(up);
    camera->OrthogonalizeViewUp();
  }
}

//------------------------------------------------------------------------------
void Picture::Move(double right, double up)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    const double half = camera->GetParallelProjection()
      ? camera->GetParallelScale()
      : camera->GetDistance() * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    look::CameraPlace view = look::GetPlace(camera);
    double aside[3], upwards[3];
    vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), aside);
    vtkMath::Normalize(aside);
    vtkMath::Cross(aside, camera->GetDirectionOfProjection(), upwards);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double step = 2.0 * half * (right * aside[i] + up * upwards[i]);
      view.Position[i] += step;
      view.FocalPoint[i] += step;
    }
    this->Place(view);
  }
}

//------------------------------------------------------------------------------
void Picture::Zoom(double factor)
{
  if (this->GetRenderer())
  {
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    camera->GetParallelProjection() ? camera->SetParallelScale(camera->GetParallelScale() / factor)
                                    : camera->Dolly(factor);
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
      // A parallel projection has no view angle.
      camera->SetViewAngle(this->Now.Shown.Parse().View.Angle.value_or(look::StandardViewAngle));
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
Picture::OtherCamera::OtherCamera(Picture* picture, const look::CameraChoice& choice)
  : Shown(picture)
  , Camera(picture->GetRenderer()->GetActiveCamera())
  , Before(vtkSmartPointer<vtkCamera>::New())
{
  this->Before->DeepCopy(this->Camera);
  picture->FitClipping(); // a scalar bar that is fitted later would reset the view angle
  this->Camera->SetViewAngle(look::StandardViewAngle);
  const scene::StyledScene& scene = picture->GetScene();
  look::PlaceCamera(picture->GetRenderer(), choice, scene.GetOptions().UpAxis, scene.GetBounds());
  picture->Other = choice;
}

//------------------------------------------------------------------------------
Picture::OtherCamera::~OtherCamera()
{
  this->Camera->DeepCopy(this->Before);
  this->Shown->Other.reset();
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
    const look::CameraPlace place = look::GetPlace(camera);
    std::vector<double> numbers;
    for (const std::array<double, 3>& each : { place.Position, place.FocalPoint, place.ViewUp })
    {
      numbers.insert(numbers.end(), each.begin(), each.end());
    }
    view.Set("--camera", words::WriteNumbers(numbers));
    view.Remove("--parallel-scale");
    if (camera->GetParallelProjection())
    {
      view.Set("--parallel-scale", words::WriteNumber(camera->GetParallelScale()));
      view.Remove("--view-angle");
    }
  }
  return view;
}
}
