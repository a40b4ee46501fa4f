// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Texels of the G-buffer: their OpenGL formats by channels, their background, and their words.
#ifndef vtkRelievoTexels_h
#define vtkRelievoTexels_h

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkRelievoGBufferLayout.h"

#include <cstddef>
#include <cstdint>

namespace relievo
{
struct TexelFormat
{
  unsigned int Internal;
  unsigned int External;

  static TexelFormat Get(int channels)
  {
    switch (channels)
    {
      case 1:
        return { GL_R32UI, GL_RED_INTEGER };
      case 2:
        return { GL_RG32UI, GL_RG_INTEGER };
      default:
        return { GL_RGBA32UI, GL_RGBA_INTEGER };
    }
  }
};

// Copies every `stride`-th word.
inline void Gather(const std::uint32_t* from, int stride, std::uint32_t* to, std::ptrdiff_t count)
{
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    to[i] = from[i * stride];
  }
}

// Clears the bound draw buffers, of which the first belongs to the colour.
inline void ClearToBackground(const vtkRelievoGBufferLayout& layout)
{
  const int most = layout.GetWordsPerAttachment();
  for (int i = 0; i < layout.GetNumberOfAttachments(); ++i)
  {
    GLuint words[4] = { 0, 0, 0, 0 };
    for (int k = 0; k < most && most * i + k < layout.GetNumberOfWords(); ++k)
    {
      words[k] = layout.Background[most * i + k];
    }
    glClearBufferuiv(GL_COLOR, 1 + i, words);
  }
}
}

#endif
