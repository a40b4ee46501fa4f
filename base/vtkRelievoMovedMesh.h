// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Interface of actors whose vertex shader moves the mapper's mesh, for passes that trace the moved
// triangles on the CPU.
#ifndef vtkRelievoMovedMesh_h
#define vtkRelievoMovedMesh_h

#include "vtkRelievoBaseModule.h" // for the export macro

class vtkPolyData;

class VTKRELIEVOBASE_EXPORT vtkRelievoMovedMesh
{
public:
  virtual ~vtkRelievoMovedMesh();

  /** The mesh as drawn now, with the cells of the mapper's mesh; nullptr if it is unknown. */
  virtual vtkPolyData* GetMovedMesh() = 0;

  /**
   * A box around the moved mesh in units of the mesh, without moving it on the CPU; uninitialized
   * if unknown.
   */
  virtual void GetMovedBounds(double bounds[6]) = 0;

  /**
   * The largest coordinate that shaders round to float between the mapper's mesh and the moved one,
   * in units of the mesh.
   */
  virtual double GetRoundedReach() = 0;

  /**
   * Number of replacements in the actor's shaders that make up the move; with others the move is
   * unknown.
   */
  virtual int GetNumberOfMovingReplacements() const = 0;

protected:
  vtkRelievoMovedMesh() = default;
  vtkRelievoMovedMesh(const vtkRelievoMovedMesh&) = default;
  vtkRelievoMovedMesh& operator=(const vtkRelievoMovedMesh&) = default;
};

#endif
