// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoStageDescription.h"

//------------------------------------------------------------------------------
const char* vtkRelievoStageDescription::GetSlotName(int slot)
{
  static const char* const names[] = { "light maps", "surfaces", "shade", "composite", "display" };
  return slot >= LIGHT_MAPS && slot <= DISPLAY ? names[slot] : "none";
}
