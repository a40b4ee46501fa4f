// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean logarithm of the linear colour's luminance, made on the GPU from one frame: sums over
// squares of pixels, and over squares of these, down to one texel. The order of the additions is
// fixed, so the same colour gives the same bits.
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
  // Sums up the colour that is there now. Returns what is wrong, in words.
  std::string Measure(vtkRelievoFrameContext& context);

  ///@{
  // The sums as the uniform toneSums of a program: see measureFS.glsl.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  ///@}

  // The four sums, read back; false if nothing was measured.
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
