// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of an actor whose vertex shader moves its mapper's mesh, and which knows the moved mesh: passes
// that follow triangles on the CPU ask for it.
#ifndef vtkRelievoMovedMesh_h
#define vtkRelievoMovedMesh_h

#include "vtkRelievoShadersModule.h" // for the export macro

class vtkPolyData;

class VTKRELIEVOSHADERS_EXPORT vtkRelievoMovedMesh
{
public:
  virtual ~vtkRelievoMovedMesh();

  /** The mesh as it is drawn now, with the cells of the mapper's; nullptr if that is not known. */
  virtual vtkPolyData* GetMovedMesh() = 0;

  /** A box around it in units of the mesh, without moving it on the CPU; uninitialized without. */
  virtual void GetMovedBounds(double bounds[6]) = 0;

  /**
   * What shaders round to floats on the way from the mapper's mesh to the moved one, as the largest
   * coordinate, in units of the mesh, whose own rounding is as much as all of it.
   */
  virtual double GetRoundedReach() = 0;

  /** Replacements in the actor's shaders that make up the move; with others it is another. */
  virtual int GetNumberOfMovingReplacements() const = 0;

protected:
  vtkRelievoMovedMesh() = default;
  vtkRelievoMovedMesh(const vtkRelievoMovedMesh&) = default;
  vtkRelievoMovedMesh& operator=(const vtkRelievoMovedMesh&) = default;
};

#endif
