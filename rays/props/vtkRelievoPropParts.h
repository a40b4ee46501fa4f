// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a prop draws with a mapper's shaders: itself, the leaves of an assembly, levels of detail.
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
  vtkMatrix4x4* Matrix = nullptr; // an assembly's for the part; nullptr: the part's own
};

// The visible leaves of an assembly, the levels of detail, or the prop itself.
VTKRELIEVORAYS_EXPORT void Collect(vtkProp* prop, std::vector<Part>& parts);

// The part as an actor whose mapper's shaders take splices, or nullptr.
VTKRELIEVORAYS_EXPORT vtkActor* GetMeshActor(const Part& part);

// Whether it is drawn over the scene and without its light, as the lines of a grid: translucent by
// wish, unlit and not to be picked. Shadows have nothing to do with it.
VTKRELIEVORAYS_EXPORT bool IsAnnotation(vtkActor* actor);

// Whether the part draws nothing in three dimensions' opaque phase: texts, bars, volumes, actors
// without a mapper.
VTKRELIEVORAYS_EXPORT bool DrawsNoOpaque(const Part& part);

// Whether the prop draws only some of its parts by meshes' mappers, and can draw them alone.
VTKRELIEVORAYS_EXPORT bool IsMixed(vtkProp* prop, const std::vector<Part>& parts);

// Draws the opaque or the translucent geometry of an assembly's meshes as it draws them, and
// nothing else of it.
VTKRELIEVORAYS_EXPORT void RenderMeshes(vtkProp* prop, bool translucent, vtkRenderer* renderer);
}

#endif
