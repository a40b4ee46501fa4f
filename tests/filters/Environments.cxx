// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environments.h"

#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
glm::dvec3 DirectionOf(int projection, const int size[3], int slice, double column, double row)
{
  const double u = column / size[0];
  const double v = row / size[1];
  if (projection == Equirectangular)
  {
    const double longitude = 2. * vtkMath::Pi() * (u - 0.5); // 0 towards +x, a quarter towards +z
    const double latitude = vtkMath::Pi() * (v - 0.5);
    return { std::cos(latitude) * std::cos(longitude), std::sin(latitude),
      std::cos(latitude) * std::sin(longitude) };
  }
  const double a = 2. * u - 1.;
  const double b = 2. * v - 1.;
  if (projection == SphereMap)
  {
    // The mirrored ray of one that comes down -z: the ball's normal is (a, b, height).
    const double height2 = 1. - a * a - b * b;
    if (height2 < 0.)
    {
      return glm::dvec3(0.);
    }
    return glm::reflect(glm::dvec3(0., 0., -1.), glm::dvec3(a, b, std::sqrt(height2)));
  }
  // The way across and the way down of each face, as OpenGL's cube maps have them.
  static const glm::dvec3 middles[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 0, 0, -1 } };
  static const glm::dvec3 acrosses[6] = { { 0, 0, -1 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 0, 0 },
    { 1, 0, 0 }, { -1, 0, 0 } };
  static const glm::dvec3 downs[6] = { { 0, -1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 },
    { 0, -1, 0 }, { 0, -1, 0 } };
  return glm::normalize(middles[slice] + a * acrosses[slice] + b * downs[slice]);
}

//------------------------------------------------------------------------------
double SolidAngleOf(int projection, const int size[3], int slice, int column, int row)
{
  const glm::dvec3 d = DirectionOf(projection, size, slice, column + 0.5, row + 0.5);
  if (d == glm::dvec3(0.))
  {
    return 0.;
  }
  if (projection == SphereMap)
  {
    return 16. / (double(size[0]) * size[1]);
  }
  if (projection == Equirectangular)
  {
    // Between two parallels, exactly.
    const double top = std::sin(vtkMath::Pi() * ((row + 1.) / size[1] - 0.5));
    const double bottom = std::sin(vtkMath::Pi() * (double(row) / size[1] - 0.5));
    return 2. * vtkMath::Pi() / size[0] * (top - bottom);
  }
  // The exact solid angle of the rectangle from the face's middle to (x, y); the texel consists of
  // four.
  const auto corner = [&](int i, int j) {
    const double x = 2. * i / size[0] - 1.;
    const double y = 2. * j / size[1] - 1.;
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1.));
  };
  return corner(column, row) - corner(column + 1, row) - corner(column, row + 1) +
    corner(column + 1, row + 1);
}

//------------------------------------------------------------------------------
void SizeOf(int projection, int n, int size[3])
{
  size[0] = projection == Equirectangular ? 2 * n : n;
  size[1] = n;
  size[2] = projection == Cube ? 6 : 1;
}

namespace
{
// Work on each texel: its number, slice, column, row.
template <typename Work>
void ForTexels(const int size[3], Work work)
{
  vtkIdType texel = 0;
  for (int slice = 0; slice < size[2]; ++slice)
  {
    for (int row = 0; row < size[1]; ++row)
    {
      for (int column = 0; column < size[0]; ++column)
      {
        work(texel++, slice, column, row);
      }
    }
  }
}

glm::dvec3 Texel(vtkDataArray* array, vtkIdType i)
{
  return glm::dvec3(
    array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeEnvironment(const Light& light, int projection, int n)
{
  int size[3];
  SizeOf(projection, n, size);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size);
  vtkNew<vtkFloatArray> array;
  array->SetName("radiance");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  ForTexels(size, [&](vtkIdType texel, int slice, int column, int row) {
    const glm::dvec3 d = DirectionOf(projection, size, slice, column + 0.5, row + 0.5);
    const glm::dvec3 value = d == glm::dvec3(0.) ? d : light(d);
    array->SetTuple3(texel, value.x, value.y, value.z);
  });
  image->GetPointData()->SetScalars(array);
  return image;
}

//------------------------------------------------------------------------------
glm::dvec3 FluxOf(vtkImageData* image, int projection)
{
  glm::dvec3 sum(0.);
  vtkDataArray* array = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  ForTexels(size, [&](vtkIdType texel, int slice, int column, int row) {
    sum += Texel(array, texel) * SolidAngleOf(projection, size, slice, column, row);
  });
  return sum;
}

namespace
{
// The mean over a texel's solid angle: 4 x 4 samples.
glm::dvec3 MeanOf(
  const Light& light, int projection, const int size[3], int slice, int column, int row)
{
  constexpr int Samples = 4;
  const int fine[3] = { size[0] * Samples, size[1] * Samples, size[2] };
  glm::dvec3 sum(0.);
  double weights = 0.;
  for (int j = row * Samples; j < (row + 1) * Samples; ++j)
  {
    for (int i = column * Samples; i < (column + 1) * Samples; ++i)
    {
      const double weight = SolidAngleOf(projection, fine, slice, i, j);
      if (weight > 0.)
      {
        sum += weight * light(DirectionOf(projection, fine, slice, i + 0.5, j + 0.5));
        weights += weight;
      }
    }
  }
  return sum / weights;
}
}

//------------------------------------------------------------------------------
LightErrors ErrorsOf(vtkImageData* image, int projection, const Light& light)
{
  LightErrors errors = { 0., 0., 0. };
  vtkDataArray* array = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  double mean = 0.;
  int count = 0;
  ForTexels(size, [&](vtkIdType texel, int slice, int column, int row) {
    const glm::dvec3 d = DirectionOf(projection, size, slice, column + 0.5, row + 0.5);
    if (d == glm::dvec3(0.) || (projection == SphereMap && d.z < BallEnd))
    {
      return;
    }
    const glm::dvec3 truth = MeanOf(light, projection, size, slice, column, row);
    const glm::dvec3 off = glm::abs(Texel(array, texel) - truth);
    const double most = std::max({ off.x, off.y, off.z });
    mean += (truth.x + truth.y + truth.z) / 3.;
    ++count;
    errors.Mean += most;
    errors.Worst = std::max(errors.Worst, most);
    if (column == 0 || row == 0 || column == size[0] - 1 || row == size[1] - 1)
    {
      errors.WorstBorder = std::max(errors.WorstBorder, most);
    }
  });
  mean /= count;
  return { errors.Mean / count / mean, errors.Worst / mean, errors.WorstBorder / mean };
}

//------------------------------------------------------------------------------
glm::dvec3 SmoothLight(const glm::dvec3& d)
{
  return glm::dvec3(1. + 0.5 * d.x + 0.3 * d.y * d.z, 0.2 + std::exp(d.y + 0.2 * d.x - 0.1 * d.z),
    1.3 + 0.4 * d.z - 0.5 * d.x * d.y + 0.2 * std::sin(3. * d.y));
}
}
