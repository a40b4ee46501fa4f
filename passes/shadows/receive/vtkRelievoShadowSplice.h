// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts the visibility of lights into the light code of VTK's mappers.
#ifndef vtkRelievoShadowSplice_h
#define vtkRelievoShadowSplice_h

#include <string>

class vtkActor;
class vtkOpenGLPolyDataMapper;
struct vtkRelievoShadowStructure;

namespace vtkRelievoShadowSplice
{
// Before VTK replaces its tags: inserts marks that survive it.
void Mark(std::string& vertex, std::string& geometry, std::string& fragment);

// After it, for an actor's mapper. Returns the missing part, or "".
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, const vtkRelievoShadowStructure& structure);
}

#endif
