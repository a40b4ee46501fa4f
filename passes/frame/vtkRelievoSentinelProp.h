// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that draw nothing: put before and behind the props of a frame, they tell when the opaque
// geometry of whatever delegate begins and ends, when what is translucent and volumes begin, and
// when what lies over the picture does.
//
// VTK's passes ask all props whether they are translucent just before they bind the framebuffers in
// which they peel or average: that question (TranslucentAsked) is the last moment at which the
// opaque picture can be taken, and so it begins the translucent phase. Passes that do not ask begin
// it by drawing.
#ifndef vtkRelievoSentinelProp_h
#define vtkRelievoSentinelProp_h

#include "vtkActor.h"
#include "vtkProp.h"
#include "vtkProperty.h"

#include <functional>

class vtkRelievoSentinelProp : public vtkProp
{
public:
  static vtkRelievoSentinelProp* New();
  vtkTypeMacro(vtkRelievoSentinelProp, vtkProp);

  std::function<void()> Opaque;
  std::function<void()> Translucent;
  std::function<void()> TranslucentAsked; // before it is drawn, by passes that ask
  std::function<void()> Volumes;
  std::function<void()> Overlay;

  int RenderOpaqueGeometry(vtkViewport*) override { return Call(this->Opaque); }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return Call(this->Translucent); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return Call(this->TranslucentAsked); }
  int RenderVolumetricGeometry(vtkViewport*) override { return Call(this->Volumes); }
  int RenderOverlay(vtkViewport*) override { return Call(this->Overlay); }

protected:
  vtkRelievoSentinelProp() { this->PickableOff(); }
  ~vtkRelievoSentinelProp() override = default;

private:
  vtkRelievoSentinelProp(const vtkRelievoSentinelProp&) = delete;
  void operator=(const vtkRelievoSentinelProp&) = delete;

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
class vtkRelievoWireFrameSentinel : public vtkActor
{
public:
  static vtkRelievoWireFrameSentinel* New();
  vtkTypeMacro(vtkRelievoWireFrameSentinel, vtkActor);

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
  vtkRelievoWireFrameSentinel()
  {
    this->PickableOff();
    this->GetProperty()->SetRepresentationToWireframe();
  }
  ~vtkRelievoWireFrameSentinel() override = default;

private:
  vtkRelievoWireFrameSentinel(const vtkRelievoWireFrameSentinel&) = delete;
  void operator=(const vtkRelievoWireFrameSentinel&) = delete;
};

#endif
