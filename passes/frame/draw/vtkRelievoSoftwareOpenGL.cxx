// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSoftwareOpenGL.h"

#include "vtkOpenGLError.h" // for OpenGL

#include <string>

//------------------------------------------------------------------------------
bool vtkRelievoIsSoftwareOpenGL()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}
