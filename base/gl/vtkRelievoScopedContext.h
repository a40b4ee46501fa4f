// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a window's OpenGL context current, and restores the former one at the end of the scope.
// OpenGL objects have to be deleted in their own context: another one reuses their names.
#ifndef vtkRelievoScopedContext_h
#define vtkRelievoScopedContext_h

#include "vtkOpenGLRenderWindow.h"

class vtkRelievoScopedContext
{
public:
  explicit vtkRelievoScopedContext(vtkWindow* window) // may be null
    : Window(vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    if (this->Window)
    {
      this->Window->PushContext();
    }
  }
  ~vtkRelievoScopedContext()
  {
    if (this->Window)
    {
      this->Window->PopContext();
    }
  }
  vtkRelievoScopedContext(const vtkRelievoScopedContext&) = delete;
  void operator=(const vtkRelievoScopedContext&) = delete;

private:
  vtkOpenGLRenderWindow* Window;
};

#endif
