// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that draw nothing: put before and behind the props of a frame, they tell when the opaque
// geometry of whatever delegate begins and ends.
#ifndef vtkRelievoOpaqueMarker_h
#define vtkRelievoOpaqueMarker_h

#include "vtkActor.h"
#include "vtkProp.h"
#include "vtkProperty.h"

#include <functional>

class vtkRelievoOpaqueMarker : public vtkProp
{
public:
  static vtkRelievoOpaqueMarker* New();
  vtkTypeMacro(vtkRelievoOpaqueMarker, vtkProp);

  std::function<void()> Reached;

  int RenderOpaqueGeometry(vtkViewport*) override
  {
    if (this->Reached)
    {
      this->Reached();
    }
    return 0;
  }

protected:
  vtkRelievoOpaqueMarker() { this->PickableOff(); }
  ~vtkRelievoOpaqueMarker() override = default;

private:
  vtkRelievoOpaqueMarker(const vtkRelievoOpaqueMarker&) = delete;
  void operator=(const vtkRelievoOpaqueMarker&) = delete;
};

// Where wire frames are drawn last, and before that as surfaces into the depth buffer alone (hidden
// line removal), only a wire frame comes behind them.
class vtkRelievoWireFrameMarker : public vtkActor
{
public:
  static vtkRelievoWireFrameMarker* New();
  vtkTypeMacro(vtkRelievoWireFrameMarker, vtkActor);

  std::function<void()> Reached;

  int RenderOpaqueGeometry(vtkViewport*) override
  {
    if (this->Reached && this->GetProperty()->GetRepresentation() == VTK_WIREFRAME)
    {
      this->Reached();
    }
    return 0;
  }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }

protected:
  vtkRelievoWireFrameMarker()
  {
    this->PickableOff();
    this->GetProperty()->SetRepresentationToWireframe();
  }
  ~vtkRelievoWireFrameMarker() override = default;

private:
  vtkRelievoWireFrameMarker(const vtkRelievoWireFrameMarker&) = delete;
  void operator=(const vtkRelievoWireFrameMarker&) = delete;
};

#endif
