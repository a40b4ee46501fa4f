// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether an actor draws its mapper's mesh and nothing else.
#ifndef vtkRelievoPlainActor_h
#define vtkRelievoPlainActor_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <string>

class vtkActor;

namespace vtkRelievoPlainActor
{
// Actors of this class draw their mapper as vtkOpenGLActor does.
VTKRELIEVORAYS_EXPORT void AddClass(const std::string& name);

// Whether the actor is of such a class.
VTKRELIEVORAYS_EXPORT bool IsOfClass(vtkActor* actor);

VTKRELIEVORAYS_EXPORT bool HasOwnShaders(vtkActor* actor);
}

#endif
