// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stage's description, made once: its name, its slot in the frame, its inputs and outputs, and
// its parameters. ParaView's properties, the command line, Python and the docs are generated from
// it.
#ifndef vtkRelievoStageDescription_h
#define vtkRelievoStageDescription_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoParameterList.h"
#include "vtkRelievoResourceName.h"

#include <string>
#include <vector>

struct VTKRELIEVOFRAME_EXPORT vtkRelievoStageDescription : vtkRelievoParameterList
{
  // Phase of the frame. Within a slot, writers of a resource run before its readers.
  enum Slots
  {
    LIGHT_MAPS = 0, // before the camera's drawing
    SURFACES = 1,   // during the opaque geometry, and right after it
    SHADE = 2,      // light that is added per pixel
    COMPOSITE = 3,  // works on the linear colour
    DISPLAY = 4     // makes the picture from the linear colour, or replaces it
  };

  std::string Name;  // lower-case words joined by _
  std::string Label; // for users: "Depth Fade"
  std::string Help;  // one sentence
  int Slot = COMPOSITE;
  int Order = 0; // among stages of a slot that change one resource: the smallest first
  std::vector<vtkRelievoResourceName> Reads;
  // `color` included: the stage changes, or blends onto, the linear colour.
  std::vector<vtkRelievoResourceName> Writes;
  std::vector<std::string> Layers; // outputs that users can also request by name
  bool WritesArrays = false;       // and any layer whose name is not among another stage's Layers

  // Whether a frame runs the stage for its requested outputs without being switched on by a user.
  bool OnByDefault = false;

  // Whether the switch only affects the picture: the stage also writes layers, and other stages'
  // inputs, while it is off.
  bool ServesWhenOff = false;

  // Whether the stage needs data beside its parameters: without data it is idle.
  bool TakesData = false;

  static const char* GetSlotName(int slot);
};

#endif
