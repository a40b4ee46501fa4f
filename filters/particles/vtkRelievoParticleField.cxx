// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleField.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoNoiseCell.h"
#include "vtkRelievoVoxelMeshes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace relievo;

namespace
{
// Rms lengths, per cell, of the noise's gradient and of the product of both noises' gradients
// (measured at 3e6 positions; testSurfaceParticles checks the speeds).
constexpr double GradientLength = 3.004;
constexpr double ProductLength = 7.630;

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

//------------------------------------------------------------------------------
struct vtkRelievoParticleField::Leaf
{
  vtkSmartPointer<vtkDataSet> Data; // a copy, unaffected by later changes of the input
  vtkImageData* Image = nullptr;    // with the array on its points
  vtkSmartPointer<vtkDataArray> Array;
  bool OnCells = false;
  vtkNew<vtkStaticCellLocator> Locator; // used without an image
};

//------------------------------------------------------------------------------
vtkRelievoParticleField::vtkRelievoParticleField() = default;

//------------------------------------------------------------------------------
vtkRelievoParticleField::~vtkRelievoParticleField() = default;

//------------------------------------------------------------------------------
std::string vtkRelievoParticleField::SetArray(vtkDataObject* data, const std::string& name)
{
  this->Leaves.clear();
  bool found = false;
  for (vtkDataSet* set : vtkRelievoVoxelMeshes::GetLeaves(data))
  {
    vtkDataArray* ofPoints = set->GetPointData()->GetArray(name.c_str());
    vtkDataArray* array = ofPoints ? ofPoints : set->GetCellData()->GetArray(name.c_str());
    if (!array)
    {
      continue;
    }
    if (array->GetNumberOfComponents() != 3)
    {
      return "the array '" + name + "' of the field has " +
        std::to_string(array->GetNumberOfComponents()) + " components, expected 3";
    }
    found = true;
    if (set->GetNumberOfCells() == 0)
    {
      continue;
    }
    auto leaf = std::make_unique<Leaf>();
    leaf->Data = vtk::TakeSmartPointer(set->NewInstance());
    leaf->Data->ShallowCopy(set);
    leaf->Array = array;
    leaf->OnCells = !ofPoints;
    leaf->Image = ofPoints ? vtkImageData::SafeDownCast(leaf->Data) : nullptr;
    if (!leaf->Image)
    {
      leaf->Locator->SetDataSet(leaf->Data);
      leaf->Locator->BuildLocator();
    }
    this->Leaves.push_back(std::move(leaf));
  }
  return found ? std::string()
               : "the field has no array '" + name + "' of vectors on its points or cells";
}

//------------------------------------------------------------------------------
void vtkRelievoParticleField::ClearArray()
{
  this->Leaves.clear();
}

//------------------------------------------------------------------------------
vtkRelievoParticleField::Reader::Reader(const vtkRelievoParticleField& field)
  : Field(field)
{
}

//------------------------------------------------------------------------------
vtkRelievoParticleField::Reader::~Reader() = default;

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoParticleField::Reader::Gradient(
  const glm::dvec3& position, unsigned int which) const
{
  // The two noises are offset by part of a cell: every noise is 0 at the corners of its lattice.
  const glm::dvec3 cells = position / this->Field.NoiseScale + 0.375 * which;
  if (!IsFinite(cells))
  {
    return glm::dvec3(0.); // cells too narrow to be distinguished
  }
  const NoiseCell x = NoiseCell::Of(cells.x);
  const NoiseCell y = NoiseCell::Of(cells.y);
  const NoiseCell z = NoiseCell::Of(cells.z);
  return f64::relievoSimplexNoiseGradientIn(
    f64::relievoSimplexAt(f64::ivec3(x.Cell, y.Cell, z.Cell), f64::vec3(x.Part, y.Part, z.Part)),
    2 * this->Field.NoiseSeed + which);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoParticleField::Reader::Sum(const glm::dvec3& position, const glm::dvec3& noise)
{
  const glm::dvec3 sum = this->Field.Velocity + noise +
    (this->Field.Leaves.empty() ? glm::dvec3(0.) : this->OfArray(position));
  // Squares must be finite in float.
  constexpr double Fastest = 1e18;
  const double largest = std::max({ std::abs(sum.x), std::abs(sum.y), std::abs(sum.z) });
  return !IsFinite(sum) ? glm::dvec3(0.) : largest > Fastest ? sum * (Fastest / largest) : sum;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoParticleField::Reader::OnSurface(
  const glm::dvec3& position, const glm::dvec3& normal)
{
  // The curl of noise times the normal has no divergence on the surface.
  glm::dvec3 noise(0.);
  if (this->Field.NoiseSpeed != 0.)
  {
    // Two thirds of the squared length are tangential.
    const double scale = this->Field.NoiseSpeed / GradientLength * std::sqrt(1.5);
    noise = scale * glm::cross(normal, this->Gradient(position, 0));
  }
  return this->Sum(position, noise);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoParticleField::Reader::InSpace(const glm::dvec3& position)
{
  // The cross product of the gradients is the curl of one noise times the gradient of the other.
  glm::dvec3 noise(0.);
  if (this->Field.NoiseSpeed != 0.)
  {
    noise = this->Field.NoiseSpeed / ProductLength *
      glm::cross(this->Gradient(position, 0), this->Gradient(position, 1));
  }
  return this->Sum(position, noise);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoParticleField::Reader::OfArray(const glm::dvec3& position)
{
  double least = std::numeric_limits<double>::infinity();
  glm::dvec3 found(0.);
  for (const auto& leaf : this->Field.Leaves)
  {
    const auto value = [&leaf](vtkIdType id) {
      double tuple[3];
      leaf->Array->GetTuple(id, tuple);
      return glm::dvec3(tuple[0], tuple[1], tuple[2]);
    };
    if (leaf->Image)
    {
      int cell[3];
      double part[3];
      // Outside an image, its field is 0.
      if (least > 0. && leaf->Image->ComputeStructuredCoordinates(&position.x, cell, part))
      {
        least = 0.;
        found = glm::dvec3(0.);
        const int* extent = leaf->Image->GetExtent();
        for (int corner = 0; corner < 8; ++corner)
        {
          int at[3];
          double weight = 1.;
          for (int axis = 0; axis < 3; ++axis)
          {
            const int high = corner >> axis & 1;
            at[axis] = std::min(cell[axis] + high, extent[2 * axis + 1]);
            weight *= high ? part[axis] : 1. - part[axis];
          }
          if (weight > 0.) // non-finite values count only where they have weight
          {
            found += weight * value(leaf->Image->ComputePointId(at));
          }
        }
      }
      continue;
    }
    double closest[3];
    vtkIdType id = -1;
    int part = 0;
    double distance2 = 0.;
    glm::dvec3 place = position; // VTK takes no const pointer
    int inside = 0;
    // Most positions lie on the data: searching a small ball is much faster than the whole.
    if (!leaf->Locator->FindClosestPointWithinRadius(
          &place.x, this->Field.Near, closest, this->Cell, id, part, distance2, inside))
    {
      leaf->Locator->FindClosestPoint(&place.x, closest, this->Cell, id, part, distance2);
    }
    if (id < 0 || !(distance2 < least))
    {
      continue;
    }
    least = distance2;
    if (leaf->OnCells)
    {
      found = value(id);
      continue;
    }
    const vtkIdType points = this->Cell->GetNumberOfPoints();
    this->Weights.assign(static_cast<std::size_t>(std::max<vtkIdType>(points, 8)), 0.);
    double parametric[3];
    double nearest[3];
    this->Cell->EvaluatePosition(
      closest, nearest, part, parametric, distance2, this->Weights.data());
    found = glm::dvec3(0.);
    for (vtkIdType i = 0; i < points; ++i)
    {
      const double weight = this->Weights[static_cast<std::size_t>(i)];
      if (weight != 0.)
      {
        found += weight * value(this->Cell->GetPointId(static_cast<int>(i)));
      }
    }
  }
  return found;
}
