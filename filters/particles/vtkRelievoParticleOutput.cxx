// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleOutput.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

namespace
{
vtkSmartPointer<vtkFloatArray> Floats(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

// Rotates x to the normal and y to the velocity; any rotation about x without a velocity.
glm::quat Orientation(const glm::vec3& normal, const glm::vec3& velocity)
{
  glm::vec3 y = velocity - glm::dot(velocity, normal) * normal;
  if (!(glm::dot(y, y) > 0.F))
  {
    y = std::abs(normal.z) < 0.9F ? glm::vec3(0.F, 0.F, 1.F) : glm::vec3(1.F, 0.F, 0.F);
    y -= glm::dot(y, normal) * normal;
  }
  y = glm::normalize(y);
  return glm::normalize(glm::quat_cast(glm::mat3(normal, y, glm::cross(normal, y))));
}
}

//------------------------------------------------------------------------------
void vtkRelievoParticleOutput::Number(vtkIdType first, vtkIdType count) const
{
  this->Numbers = vtkSmartPointer<vtkIdTypeArray>::New();
  this->Numbers->SetName("particle");
  this->Numbers->SetNumberOfValues(count);
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(count);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  offsets->SetValue(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Numbers->SetValue(i, first + i);
    points->SetValue(i, i);
    offsets->SetValue(i, i);
  }
  this->Vertices = vtkSmartPointer<vtkCellArray>::New();
  this->Vertices->SetData(offsets, points);
}

//------------------------------------------------------------------------------
std::string vtkRelievoParticleOutput::FindReplaced(vtkDataSet* start) const
{
  std::string names;
  const auto look = [&](const char* name) {
    if (start && start->GetPointData()->HasArray(name))
    {
      names += (names.empty() ? "'" : ", '") + std::string(name) + "'";
    }
  };
  look("particle");
  look("velocity");
  if (!this->Inside)
  {
    look("normal");
  }
  if (this->Orientations && !this->Inside)
  {
    look("orientation");
  }
  return names;
}

//------------------------------------------------------------------------------
void vtkRelievoParticleOutput::Write(const vtkRelievoParticleState& state, vtkIdType first,
  vtkDataSet* start, vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(state.Positions.size());
  if (start && count > 0)
  {
    output->GetPointData()->CopyAllocate(start->GetPointData(), count);
    output->GetPointData()->CopyData(start->GetPointData(), 0, count, first);
  }
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  if (!this->Numbers || this->Numbers->GetNumberOfValues() != count)
  {
    this->Number(first, count);
  }
  const auto velocities = Floats("velocity", 3, count);
  const auto normals = Floats("normal", 3, this->Inside ? 0 : count);
  const bool turned = this->Orientations && !this->Inside;
  const auto orientations = Floats("orientation", 4, turned ? count : 0);
  vtkSMPTools::For(0, count, 4096, [&](vtkIdType begin, vtkIdType end) {
    vtkRelievoParticleField::Reader reader(this->Field);
    vtkRelievoParticlePlace place;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const glm::dvec3& position = state.Positions[at];
      places->SetTypedTuple(i, &position.x);
      if (this->Inside)
      {
        const glm::vec3 velocity(reader.InSpace(position));
        velocities->SetTypedTuple(i, &velocity.x);
        continue;
      }
      this->Maps.Views[state.Views[at]].Find(position, true, place);
      velocities->SetTypedTuple(i, &place.Velocity.x);
      normals->SetTypedTuple(i, &place.Normal.x);
      if (turned)
      {
        const glm::quat turn = Orientation(place.Normal, place.Velocity);
        const float tuple[4] = { turn.w, turn.x, turn.y, turn.z };
        orientations->SetTypedTuple(i, tuple);
      }
    }
  });
  vtkNew<vtkPoints> points;
  points->SetData(places);
  output->SetPoints(points);
  output->SetVerts(this->Vertices);
  vtkPointData* data = output->GetPointData();
  data->AddArray(this->Numbers);
  data->AddArray(velocities);
  if (!this->Inside)
  {
    data->AddArray(normals);
    data->SetActiveNormals("normal");
  }
  if (turned)
  {
    data->AddArray(orientations);
  }
}
