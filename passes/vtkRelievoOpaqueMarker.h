// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A prop that draws nothing: put before and behind the props of a frame, it tells when the opaque
// geometry of whatever delegate begins and ends.
#ifndef vtkRelievoOpaqueMarker_h
#define vtkRelievoOpaqueMarker_h

#include "vtkProp.h"

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

#endif
