// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTiles.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoGetTileToPicture(vtkRenderer* renderer)
{
  glm::dmat4 m(1.0);
  const double* all = renderer->GetViewport();
  double tile[4];
  renderer->GetRenderWindow()->GetTileViewport(tile);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::max(all[axis], tile[axis]);
    const double high = std::min(all[axis + 2], tile[axis + 2]);
    const double whole = all[axis + 2] - all[axis];
    if (high > low && whole > 0.0)
    {
      m[axis][axis] = (high - low) / whole;
      m[3][axis] = (high + low - all[axis] - all[axis + 2]) / whole;
    }
  }
  return m;
}
