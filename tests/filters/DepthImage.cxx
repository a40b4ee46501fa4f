// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthImage.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace relievoTest
{
namespace
{
constexpr double ViewAngle = 30.;
constexpr double ParallelScale = 3.;
const glm::dvec3 Eye(4., -6., std::sqrt(12.)); // 8 units away
const glm::dvec3 PlaneNormal = glm::normalize(glm::dvec3(0.1, -0.2, 1.));
const glm::dvec3 SphereCenter(0.3, 0.1, 1.);

struct Ray
{
  glm::dvec3 Start;
  glm::dvec3 Direction; // advances by 1 in depth
};

Ray PixelRay(const DepthView& view, int x, int y)
{
  const glm::dvec3 forward = glm::normalize(-Eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0., 0., 1.)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double aspect = double(view.Size.x) / view.Size.y;
  const double u = (2. * x + 1.) / view.Size.x - 1. + view.WindowCenter.x;
  const double v = (2. * y + 1.) / view.Size.y - 1. + view.WindowCenter.y;
  const double half = view.Parallel ? ParallelScale : std::tan(ViewAngle * M_PI / 360.);
  const glm::dvec3 offset = right * (u * half * aspect) + up * (v * half);
  return view.Parallel ? Ray{ Eye + offset, forward } : Ray{ Eye, forward + offset };
}

// Depth of the plane within 4 of the centre; infinity outside.
double HitPlane(const Ray& ray)
{
  const double slope = glm::dot(PlaneNormal, ray.Direction);
  const double depth = -glm::dot(PlaneNormal, ray.Start) / slope;
  const glm::dvec3 place = ray.Start + depth * ray.Direction;
  return slope < 0. && glm::length(place) < 4. ? depth : std::numeric_limits<double>::infinity();
}

double HitSphere(const Ray& ray)
{
  const glm::dvec3 from = ray.Start - SphereCenter;
  const double a = glm::dot(ray.Direction, ray.Direction);
  const double b = glm::dot(ray.Direction, from);
  // The part of `from` across the ray decides; b * b - a * c would cancel.
  const glm::dvec3 across = from - ray.Direction * (b / a);
  const double rest = 1. - glm::dot(across, across);
  return rest > 0. ? (-b - std::sqrt(a * rest)) / a : std::numeric_limits<double>::infinity();
}

void AddMatrix(vtkImageData* image, const char* name, vtkMatrix4x4* matrix)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(16);
  array->InsertNextTuple(matrix->GetData());
  image->GetFieldData()->AddArray(array);
}

void AddCamera(const DepthView& view, vtkImageData* image)
{
  const vtkSmartPointer<vtkCamera> camera = MakeCamera(view);
  AddMatrix(image, "worldToCamera", camera->GetModelViewTransformMatrix());
  const double aspect = double(view.Size.x) / view.Size.y;
  AddMatrix(image, "worldToNDC", camera->GetCompositeProjectionTransformMatrix(aspect, -1., 1.));
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> MakeCamera(const DepthView& view)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  const glm::dvec3 eye = view.Center + Eye;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(view.Center.x, view.Center.y, view.Center.z);
  camera->SetViewUp(0., 0., 1.);
  camera->SetViewAngle(ViewAngle);
  camera->SetParallelScale(ParallelScale);
  camera->SetParallelProjection(view.Parallel);
  camera->SetWindowCenter(view.WindowCenter.x, view.WindowCenter.y);
  camera->SetClippingRange(2., 20.);
  return camera;
}

//------------------------------------------------------------------------------
DepthImage MakeDepthImage(const DepthView& view, bool asFloat)
{
  DepthImage made;
  made.Image = vtkSmartPointer<vtkImageData>::New();
  made.Image->SetDimensions(view.Size.x, view.Size.y, 1);
  const vtkIdType count = static_cast<vtkIdType>(view.Size.x) * view.Size.y;
  vtkSmartPointer<vtkDataArray> depth;
  depth.TakeReference(vtkDataArray::CreateDataArray(asFloat ? VTK_FLOAT : VTK_DOUBLE));
  vtkNew<vtkIntArray> id;
  vtkNew<vtkFloatArray> normal;
  depth->SetName("depth");
  id->SetName("id");
  normal->SetName("normal");
  normal->SetNumberOfComponents(3);
  depth->SetNumberOfTuples(count);
  id->SetNumberOfTuples(count);
  normal->SetNumberOfTuples(count);
  for (vtkIdType pixel = 0; pixel < count; ++pixel)
  {
    const Ray ray =
      PixelRay(view, static_cast<int>(pixel % view.Size.x), static_cast<int>(pixel / view.Size.x));
    const double plane = HitPlane(ray);
    const double sphere = HitSphere(ray);
    const double z = std::min(plane, sphere);
    const bool seen = std::isfinite(z);
    const glm::dvec3 position = seen ? ray.Start + z * ray.Direction : glm::dvec3(0.);
    const glm::dvec3 n = sphere < plane ? position - SphereCenter : PlaneNormal;
    depth->SetComponent(pixel, 0, z);
    id->SetValue(pixel, seen ? (sphere < plane ? 1 : 0) : -1);
    normal->SetTuple3(pixel, seen ? n.x : 0., seen ? n.y : 0., seen ? n.z : 0.);
    if (seen)
    {
      made.Positions.push_back(position);
      made.Pixels.push_back(pixel);
    }
  }
  made.Image->GetPointData()->AddArray(depth);
  made.Image->GetPointData()->AddArray(id);
  made.Image->GetPointData()->AddArray(normal);
  AddCamera(view, made.Image);
  return made;
}
}
