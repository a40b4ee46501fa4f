// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a layer is: an entry of vtkRelievoLayerCatalogue.
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
    POSITION, // places, shown over their extent; stored in files relative to an origin
    COLOR,
    ID,    // shown as distinct colours
    SHARE, // 0 to 1, shown in grey
    ARRAY  // of the data, by its own name
  };

  // What of a surface's point must be written for the layer to be read; several, joined by |, are a
  // case of their own in vtkRelievoLayerReader::Read.
  enum Sources
  {
    FROM_DEPTH = 1,
    FROM_NORMAL = 2,
    FROM_GEOMETRIC_NORMAL = 4,
    FROM_ALBEDO = 8,
    FROM_ID = 16,
    FROM_SHADOW = 32,
    FROM_PICTURE = 64, // it is no surface's, but the picture's
    FROM_STAGE = 128   // a stage of its own makes it, which reads it back as well
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
  double Background = std::numeric_limits<double>::quiet_NaN(); // of color NaN: the renderer's
  std::string Suffixes; // of the components in files, comma between; a file format: never changed
  std::string Help;     // one line

  // How shaders/display/layerFS.glsl decodes it: by RELIEVO_SHOW_ and this. Empty: the values are
  // read and coloured on the CPU, which any layer can be.
  std::string Shader{};

  // Of layers FROM_DEPTH alone: the values of a point seen, given in this space. Null: the depth.
  Spaces Space = VIEW;
  void (*OfPoint)(const double point[3], double* values) = nullptr;

  bool OfLight = false; // the name goes on with a light: its number, or its name

  // The name as it is told to people: "shadow_N".
  std::string GetLabel() const { return this->OfLight ? this->Name + "N" : this->Name; }
};

#endif
