// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether OpenGL makes a texture, asked before VTK makes it and complains of OpenGL's error.
#ifndef vtkRelievoTextureRoom_h
#define vtkRelievoTextureRoom_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <string>

// Why it does not make one of this size, in words, with the largest of this shape that it does
// make. `internal`, `external`, `type`: of glTexImage2D.
VTKRELIEVOFRAME_EXPORT std::string vtkRelievoFindTextureFault(
  unsigned int internal, unsigned int external, unsigned int type, int width, int height);

#endif
