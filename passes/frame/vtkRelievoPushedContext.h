// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a window's OpenGL context current while it lives; then the one before is again. Names of
// OpenGL are to be deleted so: in another context they are something else's.
#ifndef vtkRelievoPushedContext_h
#define vtkRelievoPushedContext_h

#include "vtkOpenGLRenderWindow.h"

class vtkRelievoPushedContext
{
public:
  explicit vtkRelievoPushedContext(vtkWindow* window) // may be null
    : Window(vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    if (this->Window)
    {
      this->Window->PushContext();
    }
  }
  ~vtkRelievoPushedContext()
  {
    if (this->Window)
    {
      this->Window->PopContext();
    }
  }
  vtkRelievoPushedContext(const vtkRelievoPushedContext&) = delete;
  void operator=(const vtkRelievoPushedContext&) = delete;

private:
  vtkOpenGLRenderWindow* Window;
};

#endif
