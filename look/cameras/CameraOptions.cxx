// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraOptions.h"

#include "FittedView.h"
#include "Triples.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

namespace look
{
namespace
{
double SineBetween(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  std::array<double, 3> cross{};
  vtkMath::Cross(a.data(), b.data(), cross.data());
  return Length(cross) / (Length(a) * Length(b));
}
}

//------------------------------------------------------------------------------
std::string CheckPlace(const CameraPlace& place)
{
  const std::array<double, 3> direction = Minus(place.FocalPoint, place.Position);
  if (Length(direction) == 0.0)
  {
    return "a focal point FX,FY,FZ apart from the position PX,PY,PZ";
  }
  // Below this angle VTK silently chooses another up direction.
  if (Length(place.ViewUp) == 0.0 || SineBetween(direction, place.ViewUp) < 1e-6)
  {
    return "an up direction UX,UY,UZ that is not along the view direction";
  }
  return {};
}

//------------------------------------------------------------------------------
void PlaceCamera(vtkRenderer* renderer, const CameraChoice& choice, int up, const double bounds[6])
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(choice.ParallelScale.has_value());
  if (choice.Angle)
  {
    camera->SetViewAngle(*choice.Angle);
  }
  if (choice.Place)
  {
    camera->SetPosition(choice.Place->Position.data());
    camera->SetFocalPoint(choice.Place->FocalPoint.data());
    camera->SetViewUp(choice.Place->ViewUp.data());
  }
  else
  {
    FittedView view(up);
    if (FittedView::IsFlat(bounds))
    {
      view.TurnToFlatSide(bounds);
    }
    else if (choice.From)
    {
      view.TurnTo(*choice.From);
    }
    choice.From ? view.FitTightly(renderer, bounds) : view.Fit(renderer, bounds);
  }
  if (choice.ParallelScale)
  {
    camera->SetParallelScale(*choice.ParallelScale);
  }
  renderer->ResetCameraClippingRange(); // the default range depends on the scale
  if (choice.Clip)
  {
    camera->SetClippingRange((*choice.Clip)[0], (*choice.Clip)[1]);
  }
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
