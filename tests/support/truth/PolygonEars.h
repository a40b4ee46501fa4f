// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonEars.h
 * @brief The triangles that VTK's mappers cut a polygon of five points or more into, since VTK 9.7.
 */
#ifndef relievoTestPolygonEars_h
#define relievoTestPolygonEars_h

#include <vtkRelievoVTKVersions.h>

#ifdef RELIEVO_VTK_EAR_CLIPPING
#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArrayRange.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>

#include <vector>

namespace relievoTest
{
/** Calls add(point, point, point) for each triangle of the polygon `ids` of a mesh. */
template <typename Add>
void ClipEars(vtkPolyData* mesh, const vtkIdType* ids, int count, Add&& add)
{
  std::vector<int> scratch[3];
  const auto clip = [&](auto* points) {
    vtkPolygon::EarClipPolygon3D(vtk::DataArrayTupleRange<3>(points), ids, count, scratch[0],
      scratch[1], scratch[2], [&](int a, int b, int c, int) { add(ids[a], ids[b], ids[c]); });
  };
  vtkDataArray* points = mesh->GetPoints()->GetData();
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(points))
  {
    clip(floats);
  }
  else
  {
    clip(points);
  }
}
}
#endif

#endif
