// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polygons and strips that use a point, for requested meshes; cached until a mesh changes. (VTK
// 9.1's and 9.2's vtkStaticCellLinksTemplate writes beyond its memory for vtkPolyData with several
// kinds of cells.)
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
  // The cells of every point, in the points' order.
  struct Links
  {
    std::vector<vtkIdType> Offsets; // into Cells, one more than there are points
    std::vector<vtkIdType> Cells;   // ids in the mesh

    void Build(vtkPolyData* mesh);
  };

  // Builds the links if necessary.
  const Links& Get(vtkPolyData* mesh);

  // Removes deleted and changed meshes.
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
