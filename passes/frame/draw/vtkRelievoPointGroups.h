// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Groups of neighbouring points of meshes, for looking at many points at once, and at the others in
// an order in which neighbours share the processor's caches: along a Z-order curve (G. M. Morton, A
// computer oriented geodetic data base, 1966). Kept until a mesh's points change.
#ifndef vtkRelievoPointGroups_h
#define vtkRelievoPointGroups_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <map>
#include <vector>

class vtkPolyData;

class VTKRELIEVOFRAME_EXPORT vtkRelievoPointGroups
{
public:
  struct Group
  {
    glm::dvec3 Low{ VTK_DOUBLE_MAX }; // of the points' box
    glm::dvec3 High{ -VTK_DOUBLE_MAX };
    std::size_t End = 0; // in Order; the group begins at the end of the one before
  };

  struct Mesh
  {
    std::vector<unsigned int> Order;  // vertices, group by group
    std::vector<glm::vec3> Places;    // of Order, from the lower corner of the group's box
    std::vector<unsigned int> Points; // of the vertices; empty if vertex i is at point i
    std::vector<Group> Groups;

    std::size_t GetNumberOfVertices() const
    {
      return this->Points.empty() ? this->Order.size() : this->Points.size();
    }
    unsigned int GetPoint(unsigned int vertex) const
    {
      return this->Points.empty() ? vertex : this->Points[vertex];
    }
  };

  // The groups of the points at the mesh's vertices.
  const Mesh& Get(vtkPolyData* mesh);

  void Clear() { this->Meshes.clear(); }

private:
  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    vtkMTimeType Time = 0;
    Mesh Made;
  };
  std::map<vtkPolyData*, Held> Meshes;
};

#endif
