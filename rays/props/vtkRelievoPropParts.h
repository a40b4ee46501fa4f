// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of a prop that draw with a mapper's shaders: the prop itself, the leaves of an
// assembly, levels of detail.
#ifndef vtkRelievoPropParts_h
#define vtkRelievoPropParts_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

class vtkActor;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

namespace vtkRelievoPropParts
{
struct Part
{
  vtkProp* Prop = nullptr;
  vtkMatrix4x4* Matrix = nullptr; // an assembly's matrix for the part; nullptr: the part's own
};

// The visible leaves of an assembly, the levels of detail, or the prop itself.
VTKRELIEVORAYS_EXPORT void Collect(vtkProp* prop, std::vector<Part>& parts);

// The part as an actor whose mapper's shaders accept splices, or nullptr.
VTKRELIEVORAYS_EXPORT vtkActor* GetMeshActor(const Part& part);

// Whether the actor is an annotation without light, such as the lines of a grid: forced
// translucent, unlit and not pickable. Annotations neither cast nor receive shadows.
VTKRELIEVORAYS_EXPORT bool IsAnnotation(vtkActor* actor);

// Whether the part draws nothing in the opaque 3D phase: texts, bars, volumes, actors without a
// mapper.
VTKRELIEVORAYS_EXPORT bool DrawsNoOpaque(const Part& part);

// Whether only some of the prop's parts are meshes drawn by mappers, and these can be drawn alone.
VTKRELIEVORAYS_EXPORT bool IsMixed(vtkProp* prop, const std::vector<Part>& parts);

// Draws only the opaque or the translucent geometry of an assembly's meshes.
VTKRELIEVORAYS_EXPORT void RenderMeshes(vtkProp* prop, bool translucent, vtkRenderer* renderer);
}

#endif
