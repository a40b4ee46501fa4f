// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Description of a layer: an entry of vtkRelievoLayerCatalogue.
#ifndef vtkRelievoLayer_h
#define vtkRelievoLayer_h

#include <limits>
#include <string>

struct vtkRelievoLayer
{
  enum Kinds
  {
    NUMBER,   // shown through a colour map
    VECTOR,   // unit vectors, shown as 0.5 v + 0.5
    POSITION, // positions, shown over their extent; stored in files relative to an origin
    COLOR,
    ID,    // shown as distinct colours
    SHARE, // 0 to 1, shown in grey
    ARRAY  // of the data, by the array's own name
  };

  // Values of a surface's point that the layer is read from; combinations, joined by |, are
  // separate cases in vtkRelievoLayerReader::Read.
  enum Sources
  {
    FROM_DEPTH = 1,
    FROM_NORMAL = 2,
    FROM_GEOMETRIC_NORMAL = 4,
    FROM_ALBEDO = 8,
    FROM_ID = 16,
    FROM_SHADOW = 32,
    FROM_PICTURE = 64, // belongs to the picture, not to a surface
    FROM_STAGE = 128   // made, and read back, by a stage of its own
  };

  enum Spaces
  {
    VIEW,
    WORLD
  };

  std::string Name; // "shadow_" for the layers shadow_N
  Kinds Kind = ARRAY;
  int Source = FROM_DEPTH | FROM_ID;
  int Type = 0; // VTK_FLOAT ...
  int Components = 1;
  double Background = std::numeric_limits<double>::quiet_NaN(); // NaN for color: the renderer's
  // Suffixes of the components in files, separated by commas; a file format: never change it.
  std::string Suffixes;
  std::string Help; // one line

  // Macro RELIEVO_SHOW_ + this for shaders/display/layerFS.glsl. Empty: the values are read and
  // coloured on the CPU, which works for every layer.
  std::string Shader{};

  // Only for layers FROM_DEPTH: the values at a visible point, in this space. Null: the depth.
  Spaces Space = VIEW;
  void (*OfPoint)(const double point[3], double* values) = nullptr;

  bool OfLight = false; // the name ends with a light's number or name

  // The name for users: "shadow_N".
  std::string GetLabel() const { return this->OfLight ? this->Name + "N" : this->Name; }
};

#endif
