// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraOptions.h"

#include "FittedView.h"
#include "OptionRows.h"
#include "Triples.h"
#include "Values.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <limits>

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

namespace
{
//------------------------------------------------------------------------------
void TakeCamera(CameraChoice& choice, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--camera", word, 9, "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ");
  const CameraPlace camera = { Triple(n, 0), Triple(n, 3), Triple(n, 6) };
  const std::string error = CheckPlace(camera);
  if (!error.empty())
  {
    RefuseValue("--camera", word, error);
  }
  choice.Place = camera;
}

//------------------------------------------------------------------------------
void TakeClip(CameraChoice& choice, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--clip", word, 2, "NEAR,FAR");
  if (n[0] <= 0.0 || n[1] <= n[0])
  {
    RefuseValue("--clip", word, "NEAR,FAR with 0 < NEAR < FAR");
  }
  choice.Clip = { n[0], n[1] };
}
}

//------------------------------------------------------------------------------
void AddCameraOptions(OptionRows& rows, CameraChoice& camera)
{
  rows
    .Add("--camera", "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ",
      "position, focal point, up (fitted to the scene: from the upper right, or with "
      "--preset none along -z with y or the axis of --up up; from the flat side of a flat "
      "scene)",
      camera, TakeCamera)
    .Is(OptionRows::Option::KEEPS_STYLE | OptionRows::Option::OF_ONE_VIEW);
  rows
    .AddNumber("--view-angle", "DEG",
      "full vertical angle of the perspective, degrees, @bounds@ (30)", { 0.0, 180.0, true },
      camera.Angle)
    .NamedIn("Scene", "View angle");
  rows
    .Add("--parallel-scale", "S",
      "parallel projection; S is half the picture's height in world units",
      [&camera](const std::string& word) {
        camera.ParallelScale = ParseNumberBetween(
          "--parallel-scale", word, 0.0, std::numeric_limits<double>::infinity());
      })
    .Is(OptionRows::Option::OF_ONE_VIEW);
}

//------------------------------------------------------------------------------
void AddClipOption(OptionRows& rows, CameraChoice& camera)
{
  rows
    .Add("--clip", "NEAR,FAR",
      "clipping distances from the camera, 0 < NEAR < FAR (around the scene)", camera, TakeClip)
    .Is(OptionRows::Option::KEEPS_STYLE | OptionRows::Option::OF_ONE_VIEW)
    .DropAs("the clipping distances");
}
}
