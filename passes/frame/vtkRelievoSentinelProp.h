// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that draw nothing: placed before and after the props of a frame, they report when any
// delegate's opaque geometry begins and ends, and when translucent geometry, volumes and the
// overlay begin.
//
// VTK's passes ask all props whether they are translucent just before they bind the framebuffers in
// which they peel or average: that question (TranslucentAsked) is the last moment at which the
// opaque picture can be taken, so it begins the translucent phase. For passes that do not ask, the
// first translucent drawing begins it.
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
  std::function<void()> TranslucentAsked; // before the drawing, by passes that ask
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

// With hidden line removal, wireframes are drawn last, after a drawing as surfaces into the depth
// buffer alone: only another wireframe can follow.
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
