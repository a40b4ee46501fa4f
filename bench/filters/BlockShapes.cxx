// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockShapes.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace relievoBench
{
//------------------------------------------------------------------------------
bool BlockShape::IsMeasured(const glm::dvec3& place) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (place[axis] < this->Border || place[axis] > this->Size - 1 - this->Border)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> BlockShape::Labels() const
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Size, this->Size, this->Size);
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < labels->GetNumberOfValues(); ++i)
  {
    double place[3];
    image->GetPoint(i, place);
    const bool inside = this->DistanceAt({ place[0], place[1], place[2] }) <= 0.;
    labels->SetValue(i, inside ? 1 : 0);
  }
  image->GetPointData()->SetScalars(labels);
  return image;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> BlockShape::Samples(int count) const
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0., this->Size - 1.);
  std::vector<glm::dvec3> samples;
  while (static_cast<int>(samples.size()) < count)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    glm::dvec3 place(x, y, uniform(random));
    // Projects to the shape: one step if the distance is exact, a second for rounding.
    for (int step = 0; step < 2; ++step)
    {
      place -= this->DistanceAt(place) * this->NormalAt(place);
    }
    if (this->IsMeasured(place) && std::abs(this->DistanceAt(place)) < 1e-9)
    {
      samples.push_back(place);
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
std::vector<BlockShape> BlockShapes(int size)
{
  const glm::dvec3 center = 0.5 * (size - 1) + glm::dvec3(0.31, -0.13, 0.12);
  const double radius = 0.4 * size;
  BlockShape ball;
  ball.Name = "ball";
  ball.DistanceAt = [=](const glm::dvec3& place) { return glm::length(place - center) - radius; };
  ball.NormalAt = [=](const glm::dvec3& place) { return glm::normalize(place - center); };

  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 1.));
  const auto ringAt = [=](const glm::dvec3& place) {
    const glm::dvec3 flat = place - center - glm::dot(place - center, axis) * axis;
    return center + 0.28 * size * glm::normalize(flat);
  };
  const double tube = 0.12 * size;
  BlockShape torus;
  torus.Name = "torus";
  torus.DistanceAt = [=](const glm::dvec3& place) {
    return glm::length(place - ringAt(place)) - tube;
  };
  torus.NormalAt = [=](const glm::dvec3& place) { return glm::normalize(place - ringAt(place)); };

  const glm::dvec3 up = glm::normalize(glm::dvec3(0.21, 0.37, 1.));
  BlockShape plane;
  plane.Name = "tilted plane";
  plane.DistanceAt = [=](const glm::dvec3& place) { return glm::dot(place - center, up); };
  plane.NormalAt = [=](const glm::dvec3&) { return up; };
  plane.Border = 3.;

  std::vector<BlockShape> shapes = { ball, torus, plane };
  for (BlockShape& shape : shapes)
  {
    shape.Size = size;
  }
  return shapes;
}
}
