// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPolygonCut.h"

#include "vtkPolyData.h"
#include "vtkRelievoVTKVersions.h"

#ifdef RELIEVO_VTK_EAR_CLIPPING
#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#endif

#include "vtkRelievoFormulas.h" // for GLM

//------------------------------------------------------------------------------
bool vtkRelievoPolygonCut::IsFan(vtkIdType count)
{
#ifdef RELIEVO_VTK_EAR_CLIPPING
  return count < 5;
#else
  (void)count;
  return true;
#endif
}

//------------------------------------------------------------------------------
const std::vector<vtkRelievoPolygonCut::Triangle>& vtkRelievoPolygonCut::Cut(
  vtkPolyData* mesh, const vtkIdType* points, vtkIdType count)
{
  this->Triangles.clear();
#ifdef RELIEVO_VTK_EAR_CLIPPING
  if (!vtkRelievoPolygonCut::IsFan(count))
  {
    auto add = [this](int a, int b, int c, int) { this->Triangles.push_back({ a, b, c }); };
    auto clip = [&](auto* array) {
      vtkPolygon::EarClipPolygon3D(vtk::DataArrayTupleRange<3>(array), points,
        static_cast<int>(count), this->Scratch[0], this->Scratch[1], this->Scratch[2], add);
    };
    // In the numbers' own type, like the mapper: an ear may depend on the last bit.
    vtkDataArray* array = mesh->GetPoints()->GetData();
    if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
    {
      clip(floats);
    }
    else
    {
      clip(array);
    }
    // The mapper adds empty triangles to complete the number.
    this->Triangles.resize(static_cast<std::size_t>(count - 2), Triangle{ 0, 0, 0 });
    return this->Triangles;
  }
#endif
  this->CutFan(mesh, points, count);
  return this->Triangles;
}

//------------------------------------------------------------------------------
void vtkRelievoPolygonCut::CutFan(vtkPolyData* mesh, const vtkIdType* points, vtkIdType count)
{
#ifdef RELIEVO_VTK_EAR_CLIPPING
  (void)mesh;
  (void)points;
  for (vtkIdType i = 2; i < count; ++i)
  {
    this->Triangles.push_back({ 0, i - 1, i });
  }
#else
  // Triangles with two corners at one position are not drawn.
  glm::dvec3 first;
  glm::dvec3 last;
  glm::dvec3 next;
  mesh->GetPoint(points[0], &first[0]);
  mesh->GetPoint(points[1], &last[0]);
  for (vtkIdType i = 2; i < count; ++i, last = next)
  {
    mesh->GetPoint(points[i], &next[0]);
    if (first != last && last != next && next != first)
    {
      this->Triangles.push_back({ 0, i - 1, i });
    }
  }
#endif
}
