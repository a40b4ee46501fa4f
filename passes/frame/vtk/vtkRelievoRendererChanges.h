// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts changes of a renderer's settings, except its camera, which is compared by value: a
// vtkWindowToImageFilter sets temporary cameras on all renderers and restores the former ones, and
// both change the renderer's MTime.
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

  // Starts counting for this renderer.
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
