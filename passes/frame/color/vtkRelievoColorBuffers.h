// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GPU buffers of the linear colour: the framebuffer that the delegate draws to, with the
// multisampling and depth format of the one that it replaces, and the colour that stages change.
#ifndef vtkRelievoColorBuffers_h
#define vtkRelievoColorBuffers_h

#include "vtkRelievoBoundFramebuffer.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderbuffer;
class vtkTextureObject;
class vtkWindow;

struct vtkRelievoColorBuffers
{
  ~vtkRelievoColorBuffers();

  // Allocates buffers for a viewport x, y, width, height, with `samples` samples per pixel (0 for
  // one), and the depth format of the framebuffer bound for drawing. Returns an error message, or
  // an empty string.
  std::string Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int samples);

  // Makes a texture of an OpenGL format with four components.
  static vtkSmartPointer<vtkTextureObject> MakeTexture(
    vtkOpenGLRenderWindow* window, unsigned int format, int width, int height);

  // Whether the framebuffer bound for drawing has the depth format of these buffers.
  bool HasBoundDepth() const;

  // Makes the second linear colour, which pictures without a stage that replaces the colour do not
  // need.
  void MakeSecond();

  // OpenGL's format of the colours.
  unsigned int GetFormat() const;

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer; // the delegate draws to it
  // Single-sampled; nullptr if Framebuffer is.
  vtkSmartPointer<vtkOpenGLFramebufferObject> Resolved;
  vtkSmartPointer<vtkRenderbuffer> Samples[2]; // colour and depth, multisampled
  vtkSmartPointer<vtkTextureObject> Color;     // single-sampled, as drawn
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Linear[2]; // the first one holds the present colour;
                                               // the second: see MakeSecond
  vtkSmartPointer<vtkOpenGLFramebufferObject> Pen;
  int Size[4] = { 0, 0, 0, 0 }; // of the framebuffer, and of the viewport
  int NumberOfSamples = 0;
  vtkRelievoBoundFramebuffer::DepthFormat DepthOf;
  bool Floats = false;      // in place of half floats
  bool DepthCopied = false; // this OpenGL has copied depth to the bound framebuffer
};

#endif
