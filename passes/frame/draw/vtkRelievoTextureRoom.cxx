// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTextureRoom.h"

#include "vtkOpenGLError.h" // for OpenGL

#include <algorithm>
#include <sstream>

namespace
{
bool Makes(unsigned int internal, unsigned int external, unsigned int type, int width, int height)
{
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, static_cast<GLint>(internal), width, height, 0, external,
    type, nullptr);
  GLint made = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &made);
  return made > 0;
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoFindTextureFault(
  unsigned int internal, unsigned int external, unsigned int type, int width, int height)
{
  if (Makes(internal, external, type, width, height))
  {
    return {};
  }
  int size[2] = { 1, 1 };
  double low = 0.0;
  for (double high = 1.0; high - low > 1e-3;)
  {
    const double middle = 0.5 * (low + high);
    const int w = std::max(1, static_cast<int>(middle * width));
    const int h = std::max(1, static_cast<int>(middle * height));
    const bool makes = Makes(internal, external, type, w, h);
    size[0] = makes ? w : size[0];
    size[1] = makes ? h : size[1];
    (makes ? low : high) = middle;
  }
  std::ostringstream out;
  out << "this OpenGL cannot make a texture of " << width << " x " << height
      << " pixels in this format; the largest of this shape is " << size[0] << " x " << size[1]
      << ": make the picture smaller, or capture it in tiles";
  return out.str();
}
