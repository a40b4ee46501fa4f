// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeightFields.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace relievoTest
{
//------------------------------------------------------------------------------
HeightField Sines(double period, double wave, double slope)
{
  struct Wave
  {
    glm::dvec2 Number; // radians per unit
    double Height;
    double Phase;
  };
  const double turns = std::floor(period / wave);
  const double radians = 2. * 3.14159265358979323846 / period;
  const glm::dvec2 ways[3] = { { 1., 0. }, { -0.6, 0.8 }, { 0.28, 0.5 } };
  std::vector<Wave> waves;
  for (const glm::dvec2& way : ways)
  {
    const glm::dvec2 number = radians * glm::floor(way * turns);
    // The mean square of a wave's slope is half the square of its steepest.
    const double height = slope * std::sqrt(2. / 3.) / glm::length(number);
    waves.push_back({ number, height, 0.7 * double(waves.size()) });
  }
  HeightField field;
  field.Height = [waves](double x, double y) {
    double sum = 0.;
    for (const Wave& w : waves)
    {
      sum += w.Height * std::sin(glm::dot(w.Number, glm::dvec2(x, y)) + w.Phase);
    }
    return sum;
  };
  field.Slope = [waves](double x, double y) {
    glm::dvec2 sum(0.);
    for (const Wave& w : waves)
    {
      sum += w.Number * w.Height * std::cos(glm::dot(w.Number, glm::dvec2(x, y)) + w.Phase);
    }
    return sum;
  };
  return field;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHeights(const HeightField& field, const GridOf& grid, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.Size.x, grid.Size.y, 1);
  image->SetSpacing(grid.Spacing.x, grid.Spacing.y, 1.);
  image->SetOrigin(grid.Origin.x, grid.Origin.y, 0.);
  image->AllocateScalars(type, 1);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  for (int j = 0; j < grid.Size.y; ++j)
  {
    for (int i = 0; i < grid.Size.x; ++i)
    {
      const glm::dvec2 place = grid.Origin + glm::dvec2(i, j) * grid.Spacing;
      heights->SetComponent(i + vtkIdType(j) * grid.Size.x, 0, field.Height(place.x, place.y));
    }
  }
  return image;
}

//------------------------------------------------------------------------------
NormalErrors ErrorsOf(vtkImageData* normals, const HeightField& field, const GridOf& grid)
{
  NormalErrors errors = { 0., 0., 0. };
  vtkDataArray* array = normals->GetPointData()->GetArray("normal");
  const int type = array->GetDataType();
  const double most = type == VTK_UNSIGNED_CHAR ? 255. : (type == VTK_UNSIGNED_SHORT ? 65535. : 0.);
  int count = 0;
  int seam = 0;
  for (int j = 0; j < grid.Size.y; ++j)
  {
    for (int i = 0; i < grid.Size.x; ++i)
    {
      const glm::dvec2 place = grid.Origin + glm::dvec2(i, j) * grid.Spacing;
      const glm::dvec2 slope = field.Slope(place.x, place.y);
      double tuple[3];
      array->GetTuple(i + vtkIdType(j) * grid.Size.x, tuple);
      glm::dvec3 n(tuple[0], tuple[1], tuple[2]);
      n = most > 0. ? n * (2. / most) - 1. : n;
      const glm::dvec3 truth(-slope.x, -slope.y, 1.);
      const double degrees =
        57.295779513082320877 * std::atan2(glm::length(glm::cross(n, truth)), glm::dot(n, truth));
      errors.Mean += degrees;
      errors.Worst = std::max(errors.Worst, degrees);
      ++count;
      if (i == 0 || j == 0 || i == grid.Size.x - 1 || j == grid.Size.y - 1)
      {
        errors.SeamMean += degrees;
        ++seam;
      }
    }
  }
  errors.Mean /= count;
  errors.SeamMean /= seam;
  return errors;
}
}
