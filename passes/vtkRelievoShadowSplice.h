// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts the visibility of lights into the light code of VTK's mappers.
#ifndef vtkRelievoShadowSplice_h
#define vtkRelievoShadowSplice_h

#include <string>
#include <vector>

class vtkActor;
class vtkOpenGLPolyDataMapper;

namespace vtkRelievoShadowSplice
{
// What shaders are built for; a change builds them anew.
struct Structure
{
  std::vector<int> ShaderIndices; // of the casting lights, as VTK's shaders count lights
  int Faces = 0;                  // room for maps
  int Numbers = 0;                // lights of the renderer
  bool Unlit = false;             // visibility is asked for also where no light is computed

  bool operator==(const Structure& other) const
  {
    return this->ShaderIndices == other.ShaderIndices && this->Faces == other.Faces &&
      this->Numbers == other.Numbers && this->Unlit == other.Unlit;
  }
};

// Before VTK fills its tags in: marks that survive it.
void Mark(std::string& vertex, std::string& geometry, std::string& fragment);

// After it. Returns what is missing, in words.
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, const Structure& structure);
}

#endif
