// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Errors.h"
#include "Messages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoDisplay.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace scene
{
//------------------------------------------------------------------------------
void CheckDisplay(vtkRenderWindow* window)
{
  const std::string error = vtkRelievoDisplay::Check(window);
  if (!error.empty())
  {
    throw WorkError(error);
  }
}

//------------------------------------------------------------------------------
int GetSizeLimit(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent(); // another window may have drawn since
  return vtkTextureObject::GetMaximumTextureSize(window);
}

//------------------------------------------------------------------------------
void CheckSize(
  vtkRenderWindow* window, const std::array<int, 2>& size, const std::array<int, 2>& asked)
{
  vtkOpenGLRenderWindow* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!gl)
  {
    return;
  }
  // The context is made small: a window of the full size would already exceed the limit.
  window->SetSize(1, 1);
  gl->Initialize();
  Messages::Check("OpenGL");
  const int limit = GetSizeLimit(gl);
  if (std::max(size[0], size[1]) > limit)
  {
    throw WorkError("--size " + std::to_string(asked[0]) + "x" + std::to_string(asked[1]) +
      ": OpenGL here draws at most " + std::to_string(limit) + " pixels each way");
  }
  window->SetSize(size[0], size[1]);
}
}
