// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTiles.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoMatrix.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <optional>

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

class vtkRelievoRows::Internals
{
public:
  vtkRenderWindow* Window = nullptr;
  std::optional<vtkRelievoAccess::Camera::Projection> Projection;
};

//------------------------------------------------------------------------------
vtkRelievoRows::vtkRelievoRows(vtkRenderer* renderer, int first)
  : Internal(new Internals)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 picture = vtkRelievoToGlm(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  vtkRenderWindow* window = renderer->GetRenderWindow();
  this->Internal->Window = window;
  const double all = window->GetSize()[1];
  window->SetTileViewport(0.0, first / all, 1.0, (first + window->GetActualSize()[1]) / all);
  const glm::dmat4 tile = glm::inverse(vtkRelievoGetTileToPicture(renderer)) * picture;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, tile[column][row]);
    }
  }
  this->Internal->Projection.emplace(camera, matrix);
}

//------------------------------------------------------------------------------
vtkRelievoRows::~vtkRelievoRows()
{
  this->Internal->Window->SetTileViewport(0.0, 0.0, 1.0, 1.0);
}
