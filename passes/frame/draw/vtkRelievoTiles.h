// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures drawn in tiles: choices for the whole picture are made in its own NDC.
#ifndef vtkRelievoTiles_h
#define vtkRelievoTiles_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/mat4x4.hpp>

class vtkRenderer;

// Transforms the NDC of the present tile to those of the whole picture. Identity without tiles.
VTKRELIEVOFRAME_EXPORT glm::dmat4 vtkRelievoGetTileToPicture(vtkRenderer* renderer);

#endif
