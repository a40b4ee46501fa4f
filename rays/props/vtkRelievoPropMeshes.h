// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The meshes that a prop draws as surfaces that can be followed triangle by triangle: those of
// vtkPolyDataMapper, composite meshes and glyphs.
#ifndef vtkRelievoPropMeshes_h
#define vtkRelievoPropMeshes_h

#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

class vtkProp;
class vtkRelievoGlyphPlaces;

namespace vtkRelievoPropMeshes
{
// Which meshes are wanted of a prop's.
enum class Wanted
{
  Opaque,
  Translucent, // also those, if all of a mesh has one opacity
  Geometry // all, whatever their opacity and matrix, which may flatten them or be projective, and
           // whatever points and lines are drawn beside them
};

// Appends the meshes that a prop draws. False, and nothing appended, if any of it is no triangles,
// or not those of its data: points, lines, wireframes, impostors, cut-outs, clipping planes, own
// shaders, colours of their own opacity, glyphs whose places are not known, other mappers; or if a
// mesh has too many triangles: so many, in `tooMany`, which is otherwise left as it is.
VTKRELIEVORAYS_EXPORT bool Collect(vtkProp* prop, Wanted wanted, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& meshes, vtkIdType* tooMany = nullptr);

// The largest coordinate that OpenGL rounds to a float to draw the mesh, in units of the world.
VTKRELIEVORAYS_EXPORT double GetRoundedReach(const vtkRelievoPlacedMesh& mesh);
}

#endif
