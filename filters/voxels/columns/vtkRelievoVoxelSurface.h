// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of a surface in grid coordinates, and whether they are closed.
#ifndef vtkRelievoVoxelSurface_h
#define vtkRelievoVoxelSurface_h

#include "vtkRelievoVoxelGrid.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkPolyData;

class vtkRelievoVoxelSurface
{
public:
  // Adds polygons and strips as triangles: concave polygons are cut by ears, others as fans. Ghosts
  // are left out.
  void Add(vtkPolyData* mesh, const vtkRelievoVoxelGrid& grid);

  // Whether there are triangles and each edge, by its end positions, is used an even number of
  // times: the exclusive or of a hash of all edges is 0. True in error with a probability of 2^-64.
  bool IsClosed() const { return !this->Triangles.empty() && this->EdgeHash == 0; }

  vtkIdType GetNumberOfTriangles() const
  {
    return static_cast<vtkIdType>(this->Triangles.size() / 3);
  }
  // Triangles with a non-finite point, which are left out.
  vtkIdType GetNumberOfInvalid() const { return this->Invalid; }

  // Calls work(corners) for each triangle, in threads.
  template <typename Work>
  void ForEach(Work&& work) const
  {
    vtkSMPTools::For(0, this->GetNumberOfTriangles(), 4096, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType* ids = &this->Triangles[static_cast<std::size_t>(3 * i)];
        const double* points = this->Points.data();
        work(std::array<const double*, 3>{
          { points + 3 * ids[0], points + 3 * ids[1], points + 3 * ids[2] } });
      }
    });
  }

private:
  void HashEdges(std::size_t firstTriangle);

  std::vector<double> Points;
  std::vector<std::uint64_t> PointHashes;
  std::vector<vtkIdType> Triangles;
  std::uint64_t EdgeHash = 0;
  vtkIdType Invalid = 0;
};

#endif
