// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDisplay.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderWindow.h"

#include <cstdlib>

#ifdef RELIEVO_VTK_LOADS_OSMESA
#include <initializer_list>

#include "vtkDynamicLoader.h"
#endif

#ifdef RELIEVO_HAVE_X11
#include <chrono>
#include <map>
#include <mutex>
#include <thread>

#include <X11/Xlib.h>
#endif

vtkStandardNewMacro(vtkRelievoDisplay);

#ifdef RELIEVO_HAVE_X11
namespace
{
bool Answers(const std::string& name)
{
  static std::mutex lock;
  static std::map<std::string, Display*> connected;
  const std::lock_guard<std::mutex> guard(lock);
  Display*& display = connected[name];
  // A server whose last client has just left may be starting anew.
  for (int attempt = 0; !display && !name.empty() && attempt < 10; ++attempt)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(attempt ? 100 : 0));
    display = XOpenDisplay(nullptr);
  }
  return display != nullptr;
}
}
#endif

#ifdef RELIEVO_VTK_LOADS_OSMESA
namespace
{
bool HasLibrary(std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    vtkLibHandle library = vtkDynamicLoader::OpenLibrary(name);
    if (library)
    {
      vtkDynamicLoader::CloseLibrary(library);
      return true;
    }
  }
  return false;
}

// Under the names that VTK tries.
bool HasOSMesa()
{
  return HasLibrary({ "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" });
}

// A VTK that loads X11 when it runs, as that of wheels, tries it before EGL and crashes where there
// is none. Its windows are chosen by a variable, unless the user has set it.
[[maybe_unused]] const bool UsesX11 = []() {
  const bool there = HasLibrary({ "libX11.so.6", "libX11.so" });
  return there || setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow", 0) != 0;
}();
}
#endif

//------------------------------------------------------------------------------
std::string vtkRelievoDisplay::Check(vtkRenderWindow* window)
{
#ifdef RELIEVO_VTK_LOADS_OSMESA
  if (window && window->IsA("vtkOSOpenGLRenderWindow") && !HasOSMesa())
  {
    return "no OpenGL: VTK found neither an X display, nor a driver for EGL, nor OSMesa; install a "
           "driver (without a graphics card Mesa's: libegl1 and libgl1-mesa-dri)";
  }
#endif
#ifdef RELIEVO_HAVE_X11
  if (!window || !window->IsA("vtkXOpenGLRenderWindow") || window->GetGenericDisplayId())
  {
    return {};
  }
  const char* variable = std::getenv("DISPLAY");
  const std::string name = variable ? variable : "";
  if (!Answers(name))
  {
    return "DISPLAY: got '" + name +
      "', expected an X display that answers; without a screen, run the program under xvfb-run";
  }
#else
  (void)window;
#endif
  return {};
}
