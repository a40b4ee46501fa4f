// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts what is set on a renderer, but for its camera, which is compared by what it sees: a
// vtkWindowToImageFilter sets cameras of its own on all renderers and then the former ones again,
// and the renderer's MTime has both.
#ifndef vtkRelievoRendererChanges_h
#define vtkRelievoRendererChanges_h

#include "vtkCommand.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <cstdint>

class vtkRelievoRendererChanges
{
public:
  vtkRelievoRendererChanges() = default;
  ~vtkRelievoRendererChanges() { this->Leave(); }
  vtkRelievoRendererChanges(const vtkRelievoRendererChanges&) = delete;
  vtkRelievoRendererChanges& operator=(const vtkRelievoRendererChanges&) = delete;

  // Those of this renderer from now on.
  void Watch(vtkRenderer* renderer)
  {
    if (this->Renderer == renderer)
    {
      return;
    }
    this->Leave();
    ++this->Count;
    this->Renderer = renderer;
    this->Tags[0] = renderer->AddObserver(
      vtkCommand::ModifiedEvent, this, &vtkRelievoRendererChanges::CountModified);
    this->Tags[1] = renderer->AddObserver(
      vtkCommand::ActiveCameraEvent, this, &vtkRelievoRendererChanges::UncountCamera);
  }

  std::uint64_t GetCount() const { return this->Count; }

private:
  void CountModified() { ++this->Count; }
  // vtkRenderer::SetActiveCamera calls Modified() right before.
  void UncountCamera() { --this->Count; }

  void Leave()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveObserver(this->Tags[0]);
      this->Renderer->RemoveObserver(this->Tags[1]);
    }
  }

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Tags[2] = { 0, 0 };
  std::uint64_t Count = 0;
};

#endif
