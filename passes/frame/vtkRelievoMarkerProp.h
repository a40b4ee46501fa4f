// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that draw nothing: put before and behind the props of a frame, they tell when the opaque
// geometry of whatever delegate begins and ends, when what is translucent and volumes begin, and
// when what lies over the picture does.
#ifndef vtkRelievoMarkerProp_h
#define vtkRelievoMarkerProp_h

#include "vtkActor.h"
#include "vtkProp.h"
#include "vtkProperty.h"

#include <functional>

class vtkRelievoMarkerProp : public vtkProp
{
public:
  static vtkRelievoMarkerProp* New();
  vtkTypeMacro(vtkRelievoMarkerProp, vtkProp);

  std::function<void()> Opaque;
  std::function<void()> Translucent;
  std::function<void()> TranslucentAsked; // whether there is any, before it is drawn
  std::function<void()> Volumes;
  std::function<void()> Overlay;

  int RenderOpaqueGeometry(vtkViewport*) override { return Call(this->Opaque); }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return Call(this->Translucent); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return Call(this->TranslucentAsked); }
  int RenderVolumetricGeometry(vtkViewport*) override { return Call(this->Volumes); }
  int RenderOverlay(vtkViewport*) override { return Call(this->Overlay); }

protected:
  vtkRelievoMarkerProp() { this->PickableOff(); }
  ~vtkRelievoMarkerProp() override = default;

private:
  vtkRelievoMarkerProp(const vtkRelievoMarkerProp&) = delete;
  void operator=(const vtkRelievoMarkerProp&) = delete;

  static int Call(const std::function<void()>& reached)
  {
    if (reached)
    {
      reached();
    }
    return 0;
  }
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
