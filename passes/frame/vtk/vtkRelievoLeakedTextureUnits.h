// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK 9.6's mapper of composite data leaves a texture of one texel active that no shader reads.
// Each such mapper so blocks one of a window's 16 to 32 units, until none is left for a frame.
#ifndef vtkRelievoLeakedTextureUnits_h
#define vtkRelievoLeakedTextureUnits_h

#include "vtkRelievoVTKVersions.h"

class vtkOpenGLRenderWindow;

#ifdef RELIEVO_VTK_LEAKED_TEXTURE_UNITS
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoAccess.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <vector>
#endif

namespace vtkRelievoLeakedTextureUnits
{
// Call only between draws: an actor's own texture may look alike, and is active while it is drawn.
inline void Release([[maybe_unused]] vtkOpenGLRenderWindow* window)
{
#ifdef RELIEVO_VTK_LEAKED_TEXTURE_UNITS
  std::vector<vtkTextureObject*> stray;
  for (const auto& inUse : vtkRelievoAccess::State::TextureUnits(window->GetState()))
  {
    auto* texture = const_cast<vtkTextureObject*>(inUse.first);
    if (texture->GetWidth() == 1 && texture->GetHeight() == 1 && texture->GetComponents() == 3 &&
      texture->GetVTKDataType() == VTK_UNSIGNED_CHAR)
    {
      stray.push_back(texture);
    }
  }
  for (vtkTextureObject* texture : stray)
  {
    texture->Deactivate();
  }
#endif
}
}

#endif
