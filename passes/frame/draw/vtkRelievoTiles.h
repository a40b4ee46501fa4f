// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture that is drawn in tiles: what is chosen for all of it is chosen in its own NDC.
#ifndef vtkRelievoTiles_h
#define vtkRelievoTiles_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/mat4x4.hpp>

class vtkRenderer;

// From the NDC of the tile that is drawn to those of the whole picture. Identity without tiles.
VTKRELIEVOFRAME_EXPORT glm::dmat4 vtkRelievoGetTileToPicture(vtkRenderer* renderer);

#endif
