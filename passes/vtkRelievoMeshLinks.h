// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which cells use a point, for the meshes that asked; kept while a mesh stays as it is.
#ifndef vtkRelievoMeshLinks_h
#define vtkRelievoMeshLinks_h

#include "vtkStaticCellLinksTemplate.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>

class vtkPolyData;

class vtkRelievoMeshLinks
{
public:
  using Links = vtkStaticCellLinksTemplate<vtkIdType>;

  // Builds them if need be.
  Links& Get(vtkPolyData* mesh);

  // Forgets meshes that are gone or have changed.
  void Prune();

private:
  struct Entry
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    std::unique_ptr<Links> Cells;

    bool IsValid() const;
  };
  std::map<vtkPolyData*, Entry> Entries;
};

#endif
