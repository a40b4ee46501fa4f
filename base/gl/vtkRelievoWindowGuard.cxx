// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWindowGuard.h"

#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkRelievoWindowGuard::vtkRelievoWindowGuard(vtkRenderer* renderer)
  : Renderer(renderer)
  , Window(renderer->GetRenderWindow())
  , OffScreenBuffers(this->Window->GetUseOffScreenBuffers())
{
  if (renderer->IsActiveCameraCreated())
  {
    this->Camera = renderer->GetActiveCamera();
  }
  renderer->GetViewport(this->Viewport);
  std::copy_n(this->Window->GetActualSize(), 2, this->Size); // GetSize() covers all tiles
  this->Window->GetTileScale(this->TileScale);
  this->Window->GetTileViewport(this->TileViewport);
  this->Window->SetTileScale(1, 1);
  this->Window->SetTileViewport(0.0, 0.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
vtkRelievoWindowGuard::~vtkRelievoWindowGuard()
{
  this->Renderer->SetViewport(this->Viewport);
  this->Renderer->SetActiveCamera(this->Camera);
  // Calls the base class's method: a window on the screen stays visible, only its buffers change.
  this->Window->vtkWindow::SetSize(this->Size[0], this->Size[1]);
  this->Window->SetUseOffScreenBuffers(this->OffScreenBuffers);
  this->Window->SetTileScale(this->TileScale);
  this->Window->SetTileViewport(this->TileViewport);
}
