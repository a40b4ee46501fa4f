// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Groups of neighbouring points of meshes, for looking at many points at once, and at the others in
// an order in which neighbours share the processor's caches: along a Z-order curve (G. M. Morton, A
// computer oriented geodetic data base, 1966). Objects that ask for groups of the same points share
// them, and each decides for how long it holds them.
#ifndef vtkRelievoPointGroups_h
#define vtkRelievoPointGroups_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkProp;

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

  // The groups of the points at the mesh's vertices, valid until KeepOnly or Clear. They do not
  // depend on the mesh's colours and other data.
  const Mesh& Get(vtkPolyData* mesh);

  // Drops the groups of all points except those that the props may draw as spheres.
  void KeepOnly(const std::vector<vtkProp*>& props);
  void Clear() { this->Meshes.clear(); }

  bool IsEmpty() const { return this->Meshes.empty(); }
  vtkIdType GetBytes() const; // of shared groups, this object's share

private:
  // States of points: VTK's times never repeat.
  struct Key
  {
    explicit Key(vtkPolyData* mesh);
    bool operator==(const Key& other) const;

    vtkPoints* Points;
    vtkCellArray* Verts;
    vtkMTimeType Time;
  };
  template <typename Pointer>
  struct Entry
  {
    Key Of;
    Pointer Made;
  };
  static std::shared_ptr<const Mesh> Share(vtkPolyData* mesh, const Key& key);

  std::vector<Entry<std::shared_ptr<const Mesh>>> Meshes;
};

#endif
