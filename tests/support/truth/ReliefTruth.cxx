// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReliefTruth.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkTriangleFilter.h>

#include <cmath>

namespace
{
constexpr double TwoPi = 6.28318530717958647692;

double Fraction(double x)
{
  return x - std::floor(x);
}
}

//------------------------------------------------------------------------------
double relievoTest::Waves(const glm::dvec2& uv)
{
  return 0.5 + 0.2 * std::sin(TwoPi * 3. * uv.x) * std::cos(TwoPi * 2. * uv.y) +
    0.2 * std::sin(TwoPi * (5. * uv.y + uv.x)) + 0.08 * std::cos(TwoPi * 9. * uv.x);
}

//------------------------------------------------------------------------------
relievoTest::HeightField relievoTest::Posts(double side)
{
  return [side](const glm::dvec2& uv) {
    const double across = 8. * side;
    return Fraction(8. * uv.x) < across && Fraction(8. * uv.y) < across ? 1. : 0.;
  };
}

//------------------------------------------------------------------------------
relievoTest::HeightField relievoTest::Sampled(const HeightField& field, int size)
{
  std::vector<double> texels(static_cast<std::size_t>(size) * size);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      texels[static_cast<std::size_t>(j) * size + i] =
        static_cast<float>(field(glm::dvec2(i + 0.5, j + 0.5) / static_cast<double>(size)));
    }
  }
  return [texels = std::move(texels), size](const glm::dvec2& uv) {
    const double x = Fraction(uv.x) * size - 0.5;
    const double y = Fraction(uv.y) * size - 0.5;
    const double i = std::floor(x);
    const double j = std::floor(y);
    auto at = [&](double column, double row) {
      const auto c = static_cast<std::size_t>((static_cast<int>(column) + size) % size);
      const auto r = static_cast<std::size_t>((static_cast<int>(row) + size) % size);
      return texels[r * size + c];
    };
    return glm::mix(glm::mix(at(i, j), at(i + 1., j), x - i),
      glm::mix(at(i, j + 1.), at(i + 1., j + 1.), x - i), y - j);
  };
}

//------------------------------------------------------------------------------
glm::dvec2 relievoTest::SlopeOf(const HeightField& field, const glm::dvec2& uv)
{
  constexpr double Step = 1e-6;
  const glm::dvec2 x(Step, 0.);
  const glm::dvec2 y(0., Step);
  return glm::dvec2(field(uv + x) - field(uv - x), field(uv + y) - field(uv - y)) / (2. * Step);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> relievoTest::HeightImage(const HeightField& field, int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const glm::dvec2 center(i % size + 0.5, i / size + 0.5);
    heights->SetValue(i, static_cast<float>(field(center / static_cast<double>(size))));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> relievoTest::NormalImage(
  const HeightField& field, int size, double scale)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("normal");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const glm::dvec2 uv = glm::dvec2(i % size + 0.5, i / size + 0.5) / static_cast<double>(size);
    const glm::dvec3 n = glm::normalize(glm::dvec3(-SlopeOf(field, uv) * scale / 2., 1.));
    normals->SetTuple3(i, n.x, n.y, n.z);
  }
  image->GetPointData()->SetScalars(normals);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> relievoTest::ReliefPlane(int cells)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1., -1., 0.);
  plane->SetPoint1(1., -1., 0.);
  plane->SetPoint2(-1., 1., 0.);
  plane->SetResolution(cells, cells);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

//------------------------------------------------------------------------------
relievoTest::ReliefRay relievoTest::RayOf(vtkRenderer* renderer, int x, int y)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.),
    toWorld);
  const int* size = renderer->GetSize();
  auto unproject = [&](double z) {
    const double clip[4] = { 2. * (x + 0.5) / size[0] - 1., 2. * (y + 0.5) / size[1] - 1., z, 1. };
    double world[4];
    toWorld->MultiplyPoint(clip, world);
    return glm::dvec3(world[0], world[1], world[2]) / world[3];
  };
  ReliefRay ray;
  const glm::dvec3 near = unproject(-1.);
  ray.Direction = glm::normalize(unproject(1.) - near);
  glm::dvec3 gaze;
  camera->GetDirectionOfProjection(gaze.x, gaze.y, gaze.z);
  ray.AxisPerLength = glm::dot(ray.Direction, gaze);
  camera->GetPosition(ray.Origin.x, ray.Origin.y, ray.Origin.z);
  if (camera->GetParallelProjection())
  {
    ray.Origin = near - ray.Direction * glm::dot(near - ray.Origin, gaze);
  }
  ray.OnPlane = ray.Origin - ray.Direction * (ray.Origin.z / ray.Direction.z);
  ray.HitsPlane =
    ray.Direction.z < 0. && std::abs(ray.OnPlane.x) < 1. && std::abs(ray.OnPlane.y) < 1.;
  return ray;
}

//------------------------------------------------------------------------------
glm::dvec2 relievoTest::ReliefTCoord(const ReliefRay& ray, double scale, double depth)
{
  const glm::dvec3 place = ray.OnPlane - ray.Direction * (depth * scale / ray.Direction.z);
  return (glm::dvec2(place) + 1.) / 2.;
}

//------------------------------------------------------------------------------
double relievoTest::MeetRelief(
  const HeightField& field, const ReliefRay& ray, double scale, int looks)
{
  auto isBelow = [&](double depth) { return 1. - depth <= field(ReliefTCoord(ray, scale, depth)); };
  double above = 0.;
  double below = 1.;
  for (int i = 0; i < looks; ++i)
  {
    const double depth = static_cast<double>(i) / looks;
    if (isBelow(depth))
    {
      below = depth;
      break;
    }
    above = depth;
  }
  if (below == 0.)
  {
    return 0.;
  }
  while (below - above > 1e-9)
  {
    const double middle = 0.5 * (above + below);
    (isBelow(middle) ? below : above) = middle;
  }
  return below;
}

//------------------------------------------------------------------------------
void relievoTest::LookAtRelief(vtkRenderer* renderer, double degrees, bool parallel)
{
  const double angle = degrees * TwoPi / 360.;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3 * std::sin(angle), -4. * std::sin(angle), 4. * std::cos(angle));
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->SetViewAngle(20.);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(0.7);
  camera->SetClippingRange(0.5, 9.);
}

//------------------------------------------------------------------------------
relievoTest::ReliefErrors relievoTest::CompareRelief(
  vtkImageData* layers, vtkRenderer* renderer, const HeightField& field, double scale, int stride)
{
  vtkDataArray* depths = layers->GetPointData()->GetArray("depth");
  vtkDataArray* normals = layers->GetPointData()->GetArray("normal");
  const int* size = layers->GetDimensions();
  ReliefErrors errors;
  int kept = 0;
  for (int y = stride / 2; y < size[1]; y += stride)
  {
    for (int x = stride / 2; x < size[0]; x += stride)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(y) * size[0] + x;
      const double depth = depths->GetComponent(pixel, 0);
      const ReliefRay ray = RayOf(renderer, x, y);
      if (!ray.HitsPlane || !std::isfinite(depth))
      {
        continue;
      }
      ++errors.Rays;
      const double truth = MeetRelief(field, ray, scale);
      const glm::dvec3 place = ray.Origin + ray.Direction * (depth / ray.AxisPerLength);
      const double error = std::abs(-place.z / scale - truth);
      if (error > 0.05)
      {
        errors.Missed += 1.;
        continue;
      }
      ++kept;
      errors.Depth += error;
      if (normals)
      {
        glm::dvec3 seen;
        normals->GetTuple(pixel, &seen.x);
        // A tile is 2 long.
        const glm::dvec2 slope = SlopeOf(field, ReliefTCoord(ray, scale, truth)) * scale / 2.;
        const glm::dvec3 normal(-slope, 1.);
        errors.Normal +=
          std::atan2(glm::length(glm::cross(normal, seen)), glm::dot(normal, seen)) * 360. / TwoPi;
      }
    }
  }
  errors.Missed /= errors.Rays;
  errors.Depth /= kept;
  errors.Normal /= kept;
  return errors;
}
