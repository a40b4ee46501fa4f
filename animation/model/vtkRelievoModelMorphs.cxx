// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelMorphs.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
// Adds the targets' offsets, three numbers per point. Returns whether any target has offsets.
bool AddChanges(const ModelMesh& mesh, const ModelWeights& weights,
  std::vector<float> ModelMorph::*part, std::vector<double>& values, std::size_t components)
{
  bool any = false;
  for (std::size_t i = 0; i < std::min(weights.size(), mesh.Morphs.size()); ++i)
  {
    const std::vector<float>& changes = mesh.Morphs[i].*part;
    if (weights[i] == 0. || changes.empty())
    {
      continue;
    }
    any = true;
    for (std::size_t j = 0; j < changes.size(); ++j)
    {
      values[j / 3 * components + j % 3] += weights[i] * changes[j];
    }
  }
  return any;
}

std::vector<double> GetValues(vtkDataArray* array)
{
  std::vector<double> values;
  if (array)
  {
    const int components = array->GetNumberOfComponents();
    values.resize(static_cast<std::size_t>(array->GetNumberOfTuples() * components));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, values.data() + i * components);
    }
  }
  return values;
}

// Replaces the output's directions by those with the targets' offsets, normalised to length 1.
void MorphDirections(const ModelMesh& mesh, const ModelWeights& weights,
  std::vector<float> ModelMorph::*part, int attribute, vtkPolyData* output)
{
  vtkDataArray* own = mesh.Data->GetPointData()->GetAttribute(attribute);
  if (!own)
  {
    return;
  }
  const auto components = static_cast<std::size_t>(own->GetNumberOfComponents());
  std::vector<double> values = GetValues(own);
  if (!AddChanges(mesh, weights, part, values, components))
  {
    return;
  }
  vtkNew<vtkFloatArray> moved;
  moved->SetName(own->GetName());
  moved->SetNumberOfComponents(own->GetNumberOfComponents());
  moved->SetNumberOfTuples(own->GetNumberOfTuples());
  for (vtkIdType i = 0; i < own->GetNumberOfTuples(); ++i)
  {
    double* v = values.data() + static_cast<std::size_t>(i) * components;
    const double length = std::hypot(v[0], v[1], v[2]);
    if (length > 0.)
    {
      std::for_each(v, v + 3, [length](double& number) { number /= length; });
      moved->SetTuple(i, v);
    }
    else
    {
      moved->SetTuple(i, own->GetTuple(i)); // works for any type
    }
  }
  output->GetPointData()->SetAttribute(moved, attribute);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MorphMesh(const ModelMesh& mesh, const ModelWeights& weights)
{
  if (mesh.Morphs.empty() || weights.size() == 0 || std::abs(weights).max() == 0.)
  {
    return mesh.Data;
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(mesh.Data);
  std::vector<double> values = GetValues(mesh.Data->GetPoints()->GetData());
  if (AddChanges(mesh, weights, &ModelMorph::Points, values, 3))
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh.Data->GetPoints()->GetDataType());
    points->SetNumberOfPoints(mesh.Data->GetNumberOfPoints());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, values.data() + 3 * i);
    }
    output->SetPoints(points);
  }
  MorphDirections(mesh, weights, &ModelMorph::Normals, vtkDataSetAttributes::NORMALS, output);
  MorphDirections(mesh, weights, &ModelMorph::Tangents, vtkDataSetAttributes::TANGENTS, output);
  return output;
}
}
