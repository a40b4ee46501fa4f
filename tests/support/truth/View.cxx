// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "Check.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>

namespace relievoTest
{
namespace
{
const char* NotModelled(vtkCamera* camera, vtkRenderWindow* window)
{
  double shear[3];
  camera->GetViewShear(shear);
  const int* tiles = window->GetTileScale();
  if (window->GetStereoRender())
  {
    return "stereo";
  }
  if (tiles[0] != 1 || tiles[1] != 1)
  {
    return "tiles";
  }
  if (shear[0] != 0. || shear[1] != 0. || shear[2] != 1.)
  {
    return "view shear";
  }
  if (camera->GetUseOffAxisProjection() || camera->GetUseExplicitProjectionTransformMatrix())
  {
    return "off-axis and explicit projections";
  }
  if (camera->GetUserTransform() || camera->GetUserViewTransform() ||
    !camera->GetModelTransformMatrix()->IsIdentity())
  {
    return "user and model transforms of the camera";
  }
  return nullptr;
}

// The pixel at a share of the window's size, rounded as in VTK.
int PixelAt(double share, int size)
{
  return static_cast<int>(std::lround(share * size));
}
}

//------------------------------------------------------------------------------
View::View(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (!window || !renderer->IsActiveCameraCreated())
  {
    Fail(__FILE__, __LINE__, "a View needs a renderer with a camera, in a window");
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  if (const char* what = NotModelled(camera, window))
  {
    Fail(__FILE__, __LINE__, std::string("a View does not model ") + what);
    return;
  }

  const double* viewport = renderer->GetViewport();
  const int* size = window->GetSize();
  this->Left = PixelAt(viewport[0], size[0]);
  this->Bottom = PixelAt(viewport[1], size[1]);
  this->Width = PixelAt(viewport[2], size[0]) - this->Left;
  this->Height = PixelAt(viewport[3], size[1]) - this->Bottom;

  const double* range = camera->GetClippingRange();
  this->Near = range[0];
  this->Far = range[1];
  this->Parallel = camera->GetParallelProjection() != 0;

  const double* eye = camera->GetPosition();
  const double* focus = camera->GetFocalPoint();
  const double* up = camera->GetViewUp();
  this->Eye = glm::dvec3(eye[0], eye[1], eye[2]);
  this->Forward = glm::normalize(glm::dvec3(focus[0], focus[1], focus[2]) - this->Eye);
  this->Right = glm::normalize(glm::cross(this->Forward, glm::dvec3(up[0], up[1], up[2])));
  this->Up = glm::cross(this->Right, this->Forward);

  const double aspect = camera->GetUseExplicitAspectRatio()
    ? camera->GetExplicitAspectRatio()
    : static_cast<double>(this->Width) / this->Height;
  if (this->Parallel)
  {
    this->Half = camera->GetParallelScale() * glm::dvec2(aspect, 1.);
  }
  else
  {
    const double tangent = std::tan(glm::radians(camera->GetViewAngle()) / 2.);
    this->Half = tangent *
      (camera->GetUseHorizontalViewAngle() ? glm::dvec2(1., 1. / aspect) : glm::dvec2(aspect, 1.));
  }
  const double* center = camera->GetWindowCenter();
  this->Center = glm::dvec2(center[0], center[1]);
}

//------------------------------------------------------------------------------
Ray View::PixelRay(double x, double y) const
{
  const glm::dvec2 ndc(2. * x / this->Width - 1., 2. * y / this->Height - 1.);
  const glm::dvec2 place = (ndc + this->Center) * this->Half;
  const glm::dvec3 across = place.x * this->Right + place.y * this->Up;
  Ray ray;
  ray.Origin = this->Parallel ? this->Eye + across : this->Eye;
  ray.Direction = this->Parallel ? this->Forward : this->Forward + across;
  return ray;
}

//------------------------------------------------------------------------------
double View::Depth(const glm::dvec3& world) const
{
  return glm::dot(world - this->Eye, this->Forward);
}

//------------------------------------------------------------------------------
bool View::Project(const glm::dvec3& world, glm::dvec2& pixel) const
{
  const glm::dvec3 offset = world - this->Eye;
  const double depth = glm::dot(offset, this->Forward);
  if (!this->Parallel && !(depth > 0.))
  {
    return false;
  }
  const glm::dvec2 place(glm::dot(offset, this->Right), glm::dot(offset, this->Up));
  const glm::dvec2 ndc = place / (this->Parallel ? 1. : depth) / this->Half - this->Center;
  pixel = (ndc + 1.) * 0.5 * glm::dvec2(this->Width, this->Height);
  return true;
}
}
