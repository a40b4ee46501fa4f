// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Failure.h"
#include "Messages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#ifdef RELIEVO_HAVE_X11
#include <X11/Xlib.h>
#endif

namespace cli
{
//------------------------------------------------------------------------------
void OpenDisplay(vtkRenderWindow* window)
{
#ifdef RELIEVO_HAVE_X11
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return;
  }
  // Kept open until the process ends: an X server without -noreset starts anew when its last client
  // leaves, and answers nobody meanwhile. That is also why a run just after another tries again.
  static Display* display = nullptr;
  for (int attempt = 0; !display && attempt < 10; ++attempt)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(attempt ? 100 : 0));
    display = XOpenDisplay(nullptr);
  }
  if (display)
  {
    window->SetDisplayId(display);
    return;
  }
  const char* name = std::getenv("DISPLAY");
  throw WorkError("DISPLAY: got '" + std::string(name ? name : "") +
    "', expected an X display that answers; without a screen, run: xvfb-run relievo ...");
#else
  (void)window;
#endif
}

//------------------------------------------------------------------------------
void CheckSize(vtkRenderWindow* window, const std::array<int, 2>& size)
{
  vtkOpenGLRenderWindow* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!gl)
  {
    return;
  }
  // The context is made small: asking for it at the full size would already meet the limit.
  window->SetSize(1, 1);
  gl->Initialize();
  Messages::Check("OpenGL");
  const int limit = vtkTextureObject::GetMaximumTextureSize(gl);
  if (std::max(size[0], size[1]) > limit)
  {
    throw WorkError("--size " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
      ": OpenGL here draws at most " + std::to_string(limit) + " pixels each way");
  }
  window->SetSize(size[0], size[1]);
}
}
