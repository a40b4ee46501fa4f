// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks whether OpenGL can make a texture, before VTK tries and reports OpenGL's error.
#ifndef vtkRelievoTextureRoom_h
#define vtkRelievoTextureRoom_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <string>

// Returns an error message with the largest possible size of the same shape if OpenGL cannot make a
// texture of this size, else an empty string. `internal`, `external`, `type`: see glTexImage2D.
VTKRELIEVOFRAME_EXPORT std::string vtkRelievoFindTextureFault(
  unsigned int internal, unsigned int external, unsigned int type, int width, int height);

#endif
