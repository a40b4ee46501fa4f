// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bound framebuffer, into which a frame is drawn.
#ifndef vtkRelievoBoundFramebuffer_h
#define vtkRelievoBoundFramebuffer_h

#include "vtkRelievoFrameModule.h" // for the export macro

struct VTKRELIEVOFRAME_EXPORT vtkRelievoBoundFramebuffer
{
  struct VTKRELIEVOFRAME_EXPORT DepthFormat
  {
    int Bits = 24;
    bool Float = false;
    bool Stencil = false;

    bool operator==(const DepthFormat& other) const
    {
      return this->Bits == other.Bits && this->Float == other.Float &&
        this->Stencil == other.Stencil;
    }

    unsigned int GetFormat() const; // OpenGL's
  };

  // OpenGL's number of the framebuffer bound for drawing, or for reading.
  static int GetNumber(bool reading = false);

  ///@{
  // The samples per pixel (0 for one), and the depth, of the framebuffer bound for drawing.
  static int GetSamples();
  static DepthFormat GetDepth();
  ///@}
};

#endif
