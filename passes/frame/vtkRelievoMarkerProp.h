// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A prop that draws nothing: put before and behind the props of a frame, it tells when the opaque
// geometry of whatever delegate begins and ends, and when what lies over the picture begins.
#ifndef vtkRelievoMarkerProp_h
#define vtkRelievoMarkerProp_h

#include "vtkProp.h"

#include <functional>

class vtkRelievoMarkerProp : public vtkProp
{
public:
  static vtkRelievoMarkerProp* New();
  vtkTypeMacro(vtkRelievoMarkerProp, vtkProp);

  std::function<void()> Opaque;
  std::function<void()> Overlay;

  int RenderOpaqueGeometry(vtkViewport*) override { return Call(this->Opaque); }
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

#endif
