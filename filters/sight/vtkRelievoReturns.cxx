// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoReturns.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLidar.h"
#include "vtkRelievoRayScene.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
vtkDataArray* GetColumn(vtkTable* hits, const char* name)
{
  return vtkDataArray::SafeDownCast(hits->GetColumnByName(name));
}

// Rotates directions away from their beams' axes, to ray `number` of `count` in the cone. The rays
// lie on Vogel's spiral (1979), the first one on the axis and the last one on the rim.
void TakeRays(vtkDoubleArray* axes, double divergence, int number, int count, vtkDoubleArray* rays)
{
  const double golden = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  const double radius = std::tan(vtkMath::RadiansFromDegrees(0.5 * divergence)) *
    std::sqrt(static_cast<double>(number) / std::max(count - 1, 1));
  const double right = radius * std::cos(golden * number);
  const double up = radius * std::sin(golden * number);
  rays->SetNumberOfComponents(3);
  rays->SetNumberOfTuples(axes->GetNumberOfTuples());
  for (vtkIdType i = 0; i < axes->GetNumberOfTuples(); ++i)
  {
    const double* axis = axes->GetPointer(3 * i);
    double sides[2][3];
    vtkMath::Perpendiculars(axis, sides[0], sides[1], 0.0);
    double* ray = rays->GetPointer(3 * i);
    for (int k = 0; k < 3; ++k)
    {
      ray[k] = axis[k] + right * sides[0][k] + up * sides[1][k];
    }
    vtkMath::Normalize(ray);
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoReturns::vtkRelievoReturns(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera)
  : Scene(scene)
  , Lidar(vtkRelievoLidar::SafeDownCast(camera))
{
  camera->GetRangeLimits(this->Limits);
}

//------------------------------------------------------------------------------
void vtkRelievoReturns::LimitRange(vtkTable* hits) const
{
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  if (this->Limits[0] == 0.0 && this->Limits[1] == nowhere)
  {
    return;
  }
  vtkDataArray* distances = GetColumn(hits, "distance");
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    if (!this->IsInRange(distances->GetComponent(i, 0)))
    {
      distances->SetComponent(i, 0, nowhere);
      for (const char* name : { "prop", "cell" })
      {
        GetColumn(hits, name)->SetComponent(i, 0, -1.0);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoReturns::Find(vtkDoubleArray* origins, vtkDoubleArray* directions, vtkTable* hits)
{
  const bool isCone = this->Lidar && this->Lidar->GetDivergence() > 0.0;
  const int count = isCone ? this->Lidar->GetRaysOfABeam() : 1;
  if (!this->Scene->FindNearest(origins, directions, hits))
  {
    return false;
  }
  this->LimitRange(hits);
  vtkNew<vtkDoubleArray> rays;
  vtkNew<vtkTable> others;
  for (int number = 1; number < count; ++number)
  {
    TakeRays(directions, this->Lidar->GetDivergence(), number, count, rays);
    if (!this->Scene->FindNearest(origins, rays, others))
    {
      return false;
    }
    this->LimitRange(others);
    vtkDataArray* before = GetColumn(hits, "distance");
    vtkDataArray* distances = GetColumn(others, "distance");
    for (vtkIdType i = 0; i < origins->GetNumberOfTuples(); ++i)
    {
      const double old = before->GetComponent(i, 0);
      const double found = distances->GetComponent(i, 0);
      const bool isLast = this->Lidar->GetReturn() == vtkRelievoLidar::LAST;
      if (isLast ? !std::isinf(found) && (std::isinf(old) || found > old) : found < old)
      {
        for (vtkIdType k = 0; k < hits->GetNumberOfColumns(); ++k)
        {
          hits->GetColumn(k)->SetTuple(i, i, others->GetColumn(k));
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoReturns::AddNoise(vtkDoubleArray* origins, vtkIdType first, vtkTable* hits)
{
  const double deviation = this->Lidar ? this->Lidar->GetNoise() : 0.0;
  if (deviation == 0.0)
  {
    return;
  }
  vtkDataArray* distances = GetColumn(hits, "distance");
  vtkDataArray* positions = GetColumn(hits, "position");
  const auto seed = static_cast<unsigned int>(this->Lidar->GetSeed());
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    const double distance = distances->GetComponent(i, 0);
    if (std::isinf(distance))
    {
      continue;
    }
    // Two even numbers, above 0 and at most 1, give a normal one (Box and Muller 1958).
    double even[2];
    for (unsigned int which = 0; which < 2; ++which)
    {
      even[which] =
        (1.0 +
          relievo::f64::relievoNoiseHash(static_cast<unsigned int>(first + i), which, 1u, seed)) /
        4294967296.0;
    }
    const double error =
      deviation * std::sqrt(-2.0 * std::log(even[0])) * std::cos(2.0 * vtkMath::Pi() * even[1]);
    const double moved = std::max(distance + error, 0.0);
    distances->SetComponent(i, 0, moved);
    for (int k = 0; k < 3 && distance > 0.0; ++k)
    {
      // Along the ray that returned, which may not be the beam's axis.
      const double from = origins->GetComponent(i, k);
      positions->SetComponent(
        i, k, from + moved / distance * (positions->GetComponent(i, k) - from));
    }
  }
}
