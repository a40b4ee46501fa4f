// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the shaders of what receives shadows are built for; a change builds them anew.
#ifndef vtkRelievoShadowStructure_h
#define vtkRelievoShadowStructure_h

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkMapper;

struct vtkRelievoShadowStructure
{
  struct Light
  {
    int ShaderIndex; // as VTK's shaders count lights
    bool Parallel;
    bool Cube; // room for six maps instead of one
    int Soft;  // maps that its parts are looked up in; 0: it is a point

    int GetRoom() const { return this->Cube ? 6 : std::max(this->Soft, 1); }
    bool operator==(const Light& other) const
    {
      return this->ShaderIndex == other.ShaderIndex && this->Parallel == other.Parallel &&
        this->Cube == other.Cube && this->Soft == other.Soft;
    }
  };
  std::vector<Light> Lights; // that cast
  std::string Method;        // the file of the method's own section
  bool Maps = true;          // are looked up
  bool Traced = false;       // rays decide, after the maps
  bool Colored = false;      // what passes surfaces has their colours
  bool WideFilter = false;   // of a radius above 1
  int Numbers = 0;           // lights of the renderer
  int Parts = 0;             // of soft lights
  bool Unlit = false;        // visibility is asked for also where no light is computed
  // Whose verdicts the method finds before the picture, with their mappers, which have the shaders;
  // for comparison only.
  std::vector<std::pair<vtkActor*, vtkMapper*>> Found;

  int GetFaces() const
  {
    int faces = 0;
    for (const Light& light : this->Lights)
    {
      faces += light.GetRoom();
    }
    return faces;
  }
  bool operator==(const vtkRelievoShadowStructure& other) const
  {
    return this->Lights == other.Lights && this->Method == other.Method &&
      this->Maps == other.Maps && this->Traced == other.Traced && this->Colored == other.Colored &&
      this->WideFilter == other.WideFilter && this->Numbers == other.Numbers &&
      this->Parts == other.Parts && this->Unlit == other.Unlit && this->Found == other.Found;
  }
};

#endif
