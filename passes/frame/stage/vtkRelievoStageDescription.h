// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a stage says of itself, once: its name, its slot in the frame, what it reads and writes, and
// its parameters. ParaView's properties, the command line, Python and the docs are made from it.
#ifndef vtkRelievoStageDescription_h
#define vtkRelievoStageDescription_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoParameterList.h"

#include <string>
#include <vector>

struct VTKRELIEVOFRAME_EXPORT vtkRelievoStageDescription : vtkRelievoParameterList
{
  // When a stage runs. Within a slot, what writes a resource runs before what reads it.
  enum Slots
  {
    LIGHT_MAPS = 0, // before anything is drawn for the camera
    SURFACES = 1,   // while, and right after, the opaque geometry is drawn
    SHADE = 2,      // light that is added per pixel
    COMPOSITE = 3,  // works on the linear colour
    DISPLAY = 4 // makes the picture of the linear colour, or shows something else as the picture
  };

  std::string Name;  // a lower-case word; several are joined by _
  std::string Label; // as people read it: "Depth Fade"
  std::string Help;  // one sentence
  int Slot = COMPOSITE;
  int Order = 0; // among stages of a slot that change the same resource: the smallest runs first
  std::vector<std::string> Reads;
  std::vector<std::string>
    Writes; // `color` among them: it changes or blends onto the linear colour
  std::vector<std::string> Layers; // what it writes that users can request by name, as well
  bool WritesArrays = false;       // and any layer by a name that no stage has among its Layers

  // Whether a frame runs the stage, when its resources are requested, without being told to.
  bool OnByDefault = false;

  // Whether the switch concerns the picture alone: the stage writes layers, and what other stages
  // read, while it is off as well.
  bool ServesWhenOff = false;

  // Whether it works on things that are given to it, beside its parameters: idle without any.
  bool TakesData = false;

  static const char* GetSlotName(int slot);
};

#endif
