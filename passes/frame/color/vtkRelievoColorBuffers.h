// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the linear colour holds on the GPU: the framebuffer that the delegate draws to, of the same
// multisampling and depth format as the one in whose place it is, and the colour that stages
// change.
#ifndef vtkRelievoColorBuffers_h
#define vtkRelievoColorBuffers_h

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
  struct DepthFormat
  {
    int Bits = 24;
    bool Float = false;
    bool Stencil = false;
  };

  ~vtkRelievoColorBuffers();

  // Buffers for a viewport x, y, width, height, with so many samples of each pixel, 0 for one, and
  // depths as the framebuffer that is bound for drawing has them. Returns why not, in words.
  std::string Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int samples);

  // A texture of one of OpenGL's formats with four components.
  static vtkSmartPointer<vtkTextureObject> MakeTexture(
    vtkOpenGLRenderWindow* window, unsigned int format, int width, int height);

  // For drawing, or for reading.
  static int GetBoundFramebuffer(bool reading = false);

  // Whether what is bound for drawing keeps depths as these buffers do.
  bool HasBoundDepth() const;

  ///@{
  // What is bound for drawing: samples of each pixel, 0 for one; bits of its depth.
  static int GetBoundSamples();
  static int GetBoundDepthBits();
  ///@}

  // OpenGL's format for depths as what is bound for drawing has them.
  static unsigned int GetBoundDepthFormat();

  // OpenGL's format of the colours.
  unsigned int GetFormat() const;

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer; // that the delegate draws to
  vtkSmartPointer<vtkOpenGLFramebufferObject> Resolved;    // of one sample; nullptr if it is that
  vtkSmartPointer<vtkRenderbuffer> Samples[2];             // colour and depth, multisampled
  vtkSmartPointer<vtkTextureObject> Color;                 // of one sample, as it was drawn
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Linear[2]; // the first is the colour now
  vtkSmartPointer<vtkOpenGLFramebufferObject> Pen;
  int Size[4] = { 0, 0, 0, 0 }; // of the framebuffer, and of the viewport
  int NumberOfSamples = 0;
  DepthFormat DepthOf;
  bool Floats = false;      // instead of half floats
  bool DepthCopied = false; // this OpenGL has copied it to what was bound
};

#endif
