// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The meshes of a prop that are drawn as surfaces and can be traced triangle by triangle: those of
// vtkPolyDataMapper, composite meshes and glyphs.
#ifndef vtkRelievoPropMeshes_h
#define vtkRelievoPropMeshes_h

#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

class vtkMapper;
class vtkProp;
class vtkRelievoGlyphPlaces;

namespace vtkRelievoPropMeshes
{
// Selection of a prop's meshes.
enum class Wanted
{
  Opaque,
  Translucent, // and translucent meshes of constant opacity
  Geometry // all meshes, of any opacity, with singular and projective matrices, and with points and
           // lines next to them
};

// Appends the meshes that a prop draws. False, with nothing appended, if a part is not made of
// triangles of its data: points, lines, wireframes, impostors, cut-outs, clipping planes, user
// shaders, colours with their own opacity, glyphs with unknown places, other mappers; or if a mesh
// has too many triangles, whose number `tooMany` receives (otherwise it is unchanged).
VTKRELIEVORAYS_EXPORT bool Collect(vtkProp* prop, Wanted wanted, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& meshes, vtkIdType* tooMany = nullptr);

// Whether VTK shifts and scales the points of a mesh before it rounds them to floats, unless its
// mapper chooses otherwise or draws blocks.
VTKRELIEVORAYS_EXPORT bool IsShifted(vtkPolyData* mesh);

// The largest coordinate of the mesh that OpenGL's buffers hold as a float, in the mesh's units.
// The mapper, which does not draw blocks, may choose how VTK shifts them.
VTKRELIEVORAYS_EXPORT double GetReach(vtkMapper* mapper, vtkPolyData* mesh);

// The largest coordinate that OpenGL rounds to float to draw the mesh, in world units.
VTKRELIEVORAYS_EXPORT double GetRoundedReach(const vtkRelievoPlacedMesh& mesh);
}

#endif
