// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean logarithm of the linear colour's luminance, computed on the GPU from one frame: sums
// over squares of pixels, and over squares of these, down to one texel. The order of the additions
// is fixed, so equal colours give equal bits.
#ifndef vtkRelievoLuminanceMeter_h
#define vtkRelievoLuminanceMeter_h

#include "vtkRelievoScreenQuad.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkRelievoFrameContext;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkRelievoLuminanceMeter
{
public:
  // Sums up the present colour. Returns an error message, or an empty string.
  std::string Measure(vtkRelievoFrameContext& context);

  ///@{
  // Binds the sums as the uniform toneSums of a program: see measureFS.glsl.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  ///@}

  // Reads back the four sums; false if nothing was measured.
  bool Read(float sums[4]);

  int GetDrawCalls() const { return static_cast<int>(this->Sums.size()); }
  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  void Allocate(vtkRelievoFrameContext& context);

  vtkSmartPointer<vtkOpenGLFramebufferObject> Pen;
  std::vector<vtkSmartPointer<vtkTextureObject>> Sums; // the last has one texel
  int Size[2] = { 0, 0 };
  vtkRelievoScreenQuad First;
  vtkRelievoScreenQuad Rest;
};

#endif
