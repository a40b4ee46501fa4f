// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which polygons and strips use a point, for the meshes that asked; kept while a mesh stays as it
// is. (VTK 9.1's and 9.2's vtkStaticCellLinksTemplate writes beyond its memory for vtkPolyData of
// several kinds of cells.)
#ifndef vtkRelievoMeshLinks_h
#define vtkRelievoMeshLinks_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <vector>

class vtkPolyData;

class vtkRelievoMeshLinks
{
public:
  // The cells of every point, one point's behind the other's.
  struct Links
  {
    std::vector<vtkIdType> Offsets; // into Cells, one more than there are points
    std::vector<vtkIdType> Cells;   // ids in the mesh

    void Build(vtkPolyData* mesh);
  };

  // Builds them if need be.
  const Links& Get(vtkPolyData* mesh);

  // Forgets meshes that are gone or have changed.
  void Prune();

private:
  struct Entry
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    Links Cells;

    bool IsValid() const;
  };
  std::map<vtkPolyData*, Entry> Entries;
};

#endif
