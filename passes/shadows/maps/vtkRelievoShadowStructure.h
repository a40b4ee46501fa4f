// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The properties that the shaders of shadow receivers depend on; a change rebuilds them.
#ifndef vtkRelievoShadowStructure_h
#define vtkRelievoShadowStructure_h

#include <algorithm>
#include <string>
#include <vector>

class vtkMapper;

struct vtkRelievoShadowStructure
{
  struct Light
  {
    int ShaderIndex; // index in VTK's shaders
    bool Parallel;
    bool Cube; // reserves six maps instead of one
    int Soft;  // maps shared by its parts; 0: a point light

    int GetRoom() const { return this->Cube ? 6 : std::max(this->Soft, 1); }
    bool operator==(const Light& other) const
    {
      return this->ShaderIndex == other.ShaderIndex && this->Parallel == other.Parallel &&
        this->Cube == other.Cube && this->Soft == other.Soft;
    }
  };
  std::vector<Light> Lights; // casting lights
  std::string Method;        // file of the method's own section
  bool Maps = true;          // whether maps are looked up
  bool Traced = false;       // whether rays decide, after the maps
  bool Volumes = false;      // whether volumes cast
  bool Around = false;       // and a light is among them
  int Harmonics = 0;         // of the series of their rays; 0: nodes
  bool Spread = false;       // and a sun that dims them has a size
  bool Tinted = false;       // and their colours colour the light
  bool Colored = false;      // whether transmitted light has the surfaces' colours
  bool WideFilter = false;   // of a radius above 1
  bool Highlights = true;    // whether a surface has any
  int Numbers = 0;           // lights of the renderer
  int Parts = 0;             // of soft lights
  bool Nearest = false;      // whether their rays end in front of all casters around them
  bool Unlit = false;        // visibility is needed even if no light is computed
  bool Direct = false;       // whether the share of the casting lights is asked for
  // The mappers of actors whose verdicts the method finds before the picture; for comparison only.
  std::vector<vtkMapper*> Found;

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
      this->Volumes == other.Volumes && this->Around == other.Around &&
      this->Harmonics == other.Harmonics && this->Spread == other.Spread &&
      this->Tinted == other.Tinted && this->WideFilter == other.WideFilter &&
      this->Highlights == other.Highlights && this->Numbers == other.Numbers &&
      this->Parts == other.Parts && this->Nearest == other.Nearest && this->Unlit == other.Unlit &&
      this->Direct == other.Direct && this->Found == other.Found;
  }
};

#endif
