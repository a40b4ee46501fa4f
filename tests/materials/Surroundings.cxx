// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surroundings.h"

#include "View.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
glm::dvec3 SixColors(const glm::dvec3& d)
{
  const glm::dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z)
  {
    return d.x > 0. ? glm::dvec3(1., 0., 0.) : glm::dvec3(0., 1., 1.);
  }
  if (a.y >= a.z)
  {
    return d.y > 0. ? glm::dvec3(0., 1., 0.) : glm::dvec3(1., 0., 1.);
  }
  return d.z > 0. ? glm::dvec3(0., 0., 1.) : glm::dvec3(0.4, 0.8, 0.2);
}

//------------------------------------------------------------------------------
glm::dvec3 Smooth(const glm::dvec3& d)
{
  return glm::dvec3(0.5) +
    0.25 * glm::dvec3(d.x + 0.4 * d.y * d.z, d.y + 0.4 * d.x * d.z, d.z + 0.4 * d.x * d.y);
}

//------------------------------------------------------------------------------
glm::dvec3 IrradianceOverPi(const Light& light, const glm::dvec3& normal)
{
  constexpr int Rings = 400;
  glm::dvec3 sum(0.);
  for (int i = 0; i < Rings; ++i)
  {
    const double z = (2. * i + 1.) / Rings - 1.;
    for (int j = 0; j < 2 * Rings; ++j)
    {
      const double turn = vtkMath::Pi() * (j + 0.5) / Rings;
      const double r = std::sqrt(1. - z * z);
      const glm::dvec3 d(r * std::cos(turn), r * std::sin(turn), z);
      sum += std::max(glm::dot(d, normal), 0.) * light(d);
    }
  }
  return sum * (4. / (2. * Rings * Rings));
}

//------------------------------------------------------------------------------
double AngleToEdge(const glm::dvec3& direction)
{
  glm::dvec3 a = glm::abs(glm::normalize(direction));
  const double most = std::max({ a.x, a.y, a.z });
  const double least = std::min({ a.x, a.y, a.z });
  const double middle = a.x + a.y + a.z - most - least;
  // The plane between two sides: x = y.
  return std::asin(std::min(1., (most - middle) / std::sqrt(2.)));
}

//------------------------------------------------------------------------------
glm::dvec3 TurnedAbout(const glm::dvec3& axis, double degrees, const glm::dvec3& v)
{
  const double angle = glm::radians(degrees);
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
    (1. - std::cos(angle)) * glm::dot(axis, v) * axis;
}

//------------------------------------------------------------------------------
Photo::Photo(vtkRenderWindow* window)
{
  auto image = Picture(window);
  const int* size = image->GetDimensions();
  this->Width = size[0];
  this->Height = size[1];
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  this->Bytes.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

//------------------------------------------------------------------------------
glm::dvec3 Photo::At(int x, int y) const
{
  const unsigned char* pixel = this->Bytes.data() + 3 * (static_cast<std::size_t>(y) * Width + x);
  return glm::dvec3(pixel[0], pixel[1], pixel[2]) / 255.;
}

//------------------------------------------------------------------------------
double WorstDifference(
  vtkRenderer* renderer, const std::function<glm::dvec3(const glm::dvec3&)>& expected, int least)
{
  const Photo photo(renderer->GetRenderWindow());
  const View view(renderer);
  double worst = 0.;
  int count = 0;
  for (int y = 0; y < photo.Height; ++y)
  {
    for (int x = 0; x < photo.Width; ++x)
    {
      const glm::dvec3 truth = expected(glm::normalize(view.PixelRay(x + 0.5, y + 0.5).Direction));
      if (truth.x >= 0.)
      {
        ++count;
        const glm::dvec3 off = glm::abs(truth - photo.At(x, y));
        worst = std::max({ worst, off.x, off.y, off.z });
      }
    }
  }
  return count >= least ? 255. * worst : NAN;
}

//------------------------------------------------------------------------------
void LookAlong(
  vtkRenderer* renderer, const glm::dvec3& eye, const glm::dvec3& forward, double viewAngle)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dvec3 to = eye + forward;
  const bool steep = std::abs(glm::normalize(forward).y) > 0.9;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(to.x, to.y, to.z);
  camera->SetViewUp(0., steep ? 0. : 1., steep ? 1. : 0.);
  camera->SetViewAngle(viewAngle);
  camera->SetClippingRange(0.1, 100.);
}
}
