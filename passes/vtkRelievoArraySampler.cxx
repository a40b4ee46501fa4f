// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoArraySampler.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

vtkDataSet* GetGlyphPoints(vtkActor* actor)
{
  return actor && actor->GetMapper()
    ? vtkDataSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
    : nullptr;
}

// Corners of primitive k of a cell, as VTK's mappers cut cells: polygons into fans.
int GetCorners(int cellType, int representation, vtkIdType count, vtkIdType k, vtkIdType corners[3])
{
  const bool polygon = cellType == VTK_TRIANGLE || cellType == VTK_QUAD || cellType == VTK_POLYGON;
  if (representation == VTK_POINTS || cellType == VTK_VERTEX || cellType == VTK_POLY_VERTEX)
  {
    corners[0] = k;
    return 1;
  }
  if (cellType == VTK_LINE || cellType == VTK_POLY_LINE || representation == VTK_WIREFRAME)
  {
    corners[0] = k;
    corners[1] = polygon ? (k + 1) % count : k + 1;
    return 2;
  }
  corners[0] = polygon ? 0 : k;
  corners[1] = k + 1;
  corners[2] = k + 2;
  return 3;
}

glm::dvec3 GetPoint(vtkPolyData* mesh, vtkIdType id)
{
  glm::dvec3 point;
  mesh->GetPoint(id, &point[0]);
  return point;
}

// Shares of the corners at the ray's hit on their triangle.
void GetTriangleWeights(const glm::dvec3 p[3], const glm::dvec3& from, const glm::dvec3& along,
  double weights[3])
{
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double slope = glm::dot(normal, along);
  const double area = glm::dot(normal, normal);
  if (!(std::abs(slope) > 0.0) || !(area > 0.0))
  {
    weights[0] = weights[1] = weights[2] = 1.0 / 3.0;
    return;
  }
  const glm::dvec3 hit = from + along * (glm::dot(normal, p[0] - from) / slope);
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 edge = glm::cross(p[(i + 2) % 3] - p[(i + 1) % 3], hit - p[(i + 1) % 3]);
    weights[i] = std::max(0.0, glm::dot(edge, normal) / area);
    sum += weights[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    weights[i] /= sum;
  }
}

// Shares of a segment's ends at its point nearest to the ray.
void GetSegmentWeights(const glm::dvec3 p[2], const glm::dvec3& from, const glm::dvec3& along,
  double weights[2])
{
  const glm::dvec3 segment = p[1] - p[0];
  const glm::dvec3 across = glm::cross(along, glm::cross(along, segment));
  const double slope = glm::dot(across, segment);
  const double t = std::abs(slope) > 0.0 ? glm::dot(across, from - p[0]) / slope : 0.5;
  weights[1] = std::min(1.0, std::max(0.0, t));
  weights[0] = 1.0 - weights[1];
}
}

//------------------------------------------------------------------------------
vtkRelievoArraySampler::vtkRelievoArraySampler(const std::string& layer,
  const vtkRelievoDrawTable& draws, const vtkRelievoView& view, int width, int height)
  : Name(layer)
  , Draws(draws)
  , View(view)
  , Size(width, height)
{
  if (layer.compare(0, 6, "point:") == 0)
  {
    this->Name = layer.substr(6);
    this->AllowCells = false;
  }
  else if (layer.compare(0, 5, "cell:") == 0)
  {
    this->Name = layer.substr(5);
    this->AllowPoints = false;
  }
}

//------------------------------------------------------------------------------
vtkRelievoArraySampler::Source vtkRelievoArraySampler::Find(
  vtkDataSetAttributes* points, vtkDataSetAttributes* cells) const
{
  Source source;
  if (this->AllowPoints && points)
  {
    source.Array = points->GetArray(this->Name.c_str());
    source.OfPoints = source.Array != nullptr;
  }
  if (!source.Array && this->AllowCells && cells)
  {
    source.Array = cells->GetArray(this->Name.c_str());
  }
  return source;
}

//------------------------------------------------------------------------------
int vtkRelievoArraySampler::Prepare(int& components, std::string& wrong)
{
  bool wide = false;
  const std::vector<vtkRelievoDrawTable::Hit> meshes = this->Draws.GetMeshes();
  for (const vtkRelievoDrawTable::Hit& hit : meshes)
  {
    Source source;
    if (hit.Mesh)
    {
      source = this->Find(hit.Mesh->GetPointData(), hit.Mesh->GetCellData());
    }
    else if (vtkDataSet* glyphs = GetGlyphPoints(hit.Prop))
    {
      source = this->Find(glyphs->GetPointData(), nullptr);
    }
    if (!source.Array)
    {
      continue;
    }
    if (hit.Mesh && source.OfPoints)
    {
      // Built here, since threads that sample may not build it.
      if (hit.Mesh->NeedToBuildCells())
      {
        hit.Mesh->BuildCells();
      }
      glm::dmat4 modelToWorld(1.0);
      vtkMatrix4x4* matrix = hit.Prop->GetMatrix();
      for (int row = 0; row < 4; ++row)
      {
        for (int column = 0; column < 4; ++column)
        {
          modelToWorld[column][row] = matrix->GetElement(row, column);
        }
      }
      source.ViewToModel = glm::inverse(this->View.WorldToView * modelToWorld);
    }
    this->Sources[Key(hit.Prop, hit.Mesh)] = source;
    this->Components = std::max(this->Components, source.Array->GetNumberOfComponents());
    // Integers of four bytes and more do not fit into a float.
    wide = wide ||
      (source.Array->GetDataType() != VTK_FLOAT && source.Array->GetDataTypeSize() >= 4);
  }
  if (this->Sources.empty() && !meshes.empty())
  {
    wrong = "it is neither a layer nor a point or cell array of anything drawn. Layers are depth, "
            "range, normal, geometric_normal, position, albedo, actor, block, cell";
  }
  else if (this->Components > MaximumComponents)
  {
    wrong = "it has " + std::to_string(this->Components) + " components, at most " +
      std::to_string(MaximumComponents) + " are read";
  }
  this->Components = std::max(1, this->Components);
  components = this->Components;
  return wide ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
void vtkRelievoArraySampler::Sample(
  const vtkRelievoDrawTable::Hit& hit, int x, int y, double* values) const
{
  std::fill(values, values + this->Components, NoValue);
  if (!hit.Prop || hit.Cell < 0)
  {
    return;
  }
  auto found = this->Sources.find(Key(hit.Prop, hit.Mesh));
  if (found == this->Sources.end())
  {
    return;
  }
  const Source& source = found->second;
  if (hit.Mesh && source.OfPoints)
  {
    this->SampleInCell(hit, source, x, y, values);
  }
  else if (hit.Cell < source.Array->GetNumberOfTuples())
  {
    for (int c = 0; c < source.Array->GetNumberOfComponents(); ++c)
    {
      values[c] = source.Array->GetComponent(hit.Cell, c);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoArraySampler::SampleInCell(const vtkRelievoDrawTable::Hit& hit, const Source& source,
  int x, int y, double* values) const
{
  static thread_local vtkSmartPointer<vtkIdList> ids = vtkSmartPointer<vtkIdList>::New();
  hit.Mesh->GetCellPoints(hit.Cell, ids);
  vtkIdType corners[3];
  const int count = GetCorners(hit.Mesh->GetCellType(hit.Cell),
    hit.Prop->GetProperty()->GetRepresentation(), ids->GetNumberOfIds(), hit.GetPrimitiveInCell(),
    corners);
  if (corners[count - 1] >= ids->GetNumberOfIds())
  {
    return;
  }
  glm::dvec3 points[3];
  for (int i = 0; i < count; ++i)
  {
    corners[i] = ids->GetId(corners[i]);
    points[i] = GetPoint(hit.Mesh, corners[i]);
  }
  const glm::dvec2 ndc = relievo::f64::relievoNdcFromPixel(glm::dvec2(x, y), this->Size);
  const glm::dvec3 eye = relievo::f64::relievoEyePosition(ndc, 0.0, this->View.ViewToNDC);
  const glm::dvec3 ahead = relievo::f64::relievoEyePosition(ndc, 1.0, this->View.ViewToNDC);
  const glm::dvec3 from(source.ViewToModel * glm::dvec4(eye, 1.0));
  const glm::dvec3 along(source.ViewToModel * glm::dvec4(ahead - eye, 0.0));
  double weights[3] = { 1.0, 0.0, 0.0 };
  if (count == 3)
  {
    GetTriangleWeights(points, from, along, weights);
  }
  else if (count == 2)
  {
    GetSegmentWeights(points, from, along, weights);
  }
  for (int c = 0; c < source.Array->GetNumberOfComponents(); ++c)
  {
    values[c] = 0.0;
    for (int i = 0; i < count; ++i)
    {
      // A share of nothing keeps a NaN or an infinity at the other corner out.
      if (weights[i] > 0.0)
      {
        values[c] += weights[i] * source.Array->GetComponent(corners[i], c);
      }
    }
  }
}
