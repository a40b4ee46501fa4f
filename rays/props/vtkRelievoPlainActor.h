// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Detects actors that draw their mapper's mesh and nothing else.
#ifndef vtkRelievoPlainActor_h
#define vtkRelievoPlainActor_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <string>

class vtkActor;

namespace vtkRelievoPlainActor
{
// Registers a class whose actors draw their mapper like vtkOpenGLActor.
VTKRELIEVORAYS_EXPORT void AddClass(const std::string& name);

// Whether the actor's class is registered.
VTKRELIEVORAYS_EXPORT bool IsOfClass(vtkActor* actor);

VTKRELIEVORAYS_EXPORT bool HasOwnShaders(vtkActor* actor);
}

#endif
