// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts as triangles that can be followed: surfaces of vtkPolyDataMapper, composite meshes and
// glyphs.
#ifndef vtkRelievoPropMeshes_h
#define vtkRelievoPropMeshes_h

#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

class vtkProp;
class vtkRelievoGlyphPlaces;

namespace vtkRelievoPropMeshes
{
// Appends the meshes that a prop casts with; `translucent`: also those that are translucent. False,
// and nothing appended, if any of it is no triangles, or not those of its data: points, lines,
// wireframes, impostors, cut-outs, clipping planes, own shaders, colours of their own opacity,
// glyphs whose places are not known, other mappers.
VTKRELIEVORAYS_EXPORT bool Collect(vtkProp* prop, bool translucent, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& casters);
}

#endif
