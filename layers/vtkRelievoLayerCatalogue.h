// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers that there are: their names, types, backgrounds, how they are shown, what files call
// their components. The one place that says so; a new layer is one entry of the table.
#ifndef vtkRelievoLayerCatalogue_h
#define vtkRelievoLayerCatalogue_h

#include "vtkRelievoLayersModule.h" // for the export macro

#include <string>
#include <vector>

struct VTKRELIEVOLAYERS_EXPORT vtkRelievoLayer
{
  enum Kinds
  {
    DISTANCE, // world units from the eye; infinite where nothing is
    VECTOR,   // unit vectors, shown as 0.5 v + 0.5
    POSITION, // places, shown over their extent
    COLOR,
    ID,    // shown as distinct colours
    SHARE, // 0 to 1, shown in grey
    ARRAY  // of the data, by its own name
  };

  // What of a surface's point must be written for the layer to be read.
  enum Sources
  {
    FROM_DEPTH = 1,
    FROM_NORMAL = 2,
    FROM_GEOMETRIC_NORMAL = 4,
    FROM_ALBEDO = 8,
    FROM_ID = 16,
    FROM_SHADOW = 32,
    FROM_PICTURE = 64 // it is no surface's, but the picture's
  };

  std::string Name; // "shadow_" for the layers shadow_N
  Kinds Kind = ARRAY;
  int Source = FROM_DEPTH | FROM_ID;
  int Type = 0; // VTK_FLOAT ...
  int Components = 1;
  double Background = 0.0;
  std::string Suffixes; // of the components in files, comma between: "Z", "X,Y,Z"
  bool OfLight = false; // the name goes on with a light: its number, or its name
  std::string Help;     // one line
};

class VTKRELIEVOLAYERS_EXPORT vtkRelievoLayerCatalogue
{
public:
  // All of them, in the order in which they are listed to people.
  static const std::vector<vtkRelievoLayer>& GetAll();

  // What the name means; of kind ARRAY if it is none of the table's. A layer of a light is known by
  // the light's number only: for its name ask the frame.
  static const vtkRelievoLayer& Find(const std::string& name);

  // What the layers of lights are.
  static const vtkRelievoLayer& GetOfLight();

  // The light of a layer shadow_N by its number, or -1.
  static int GetLight(const std::string& name);
};

#endif
