// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `color`: what the delegate draws, unclamped, in linear light, RGBA16F,
// premultiplied.
//
// The delegate draws into a float framebuffer in the place of the one that was bound, of the same
// multisampling; its colours, which VTK makes for display, go through the inverse of the sRGB curve
// once, the stages change them, and Present puts them through the curve into the framebuffer that
// was bound before, with the depth.
#ifndef vtkRelievoColorTarget_h
#define vtkRelievoColorTarget_h

#include "vtkNew.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkImageData;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkRenderbuffer;
class vtkTextureObject;
class vtkWindow;

class vtkRelievoColorTarget : public vtkRelievoResource
{
public:
  vtkRelievoColorTarget();
  ~vtkRelievoColorTarget() override;

  struct DepthFormat
  {
    int Bits = 24;
    bool Float = false;
    bool Stencil = false;
  };

  // Binds the float framebuffer for what the delegate draws. Returns why it cannot, in words;
  // nothing has changed then.
  std::string Begin(vtkRelievoFrameContext& context);

  // Whether what is bound for drawing now is what Begin bound.
  bool IsBound() const;

  // Binds what was bound before Begin; the linear colour is there from now on.
  void End(vtkRelievoFrameContext& context);

  // Draws the quad over the linear colour: as the new colour, or blended.
  bool Draw(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces);

  // Writes the colour, through the sRGB curve, and the depth into the framebuffer that is bound.
  void Present(vtkRelievoFrameContext& context);

  // Adds the colour as the point array `color`, 4 float.
  std::string Read(vtkImageData* image);

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  void Allocate(vtkRelievoFrameContext& context, int samples, const DepthFormat& depth);
  void CopyWhatIsThere(vtkRelievoFrameContext& context);

  class Input;
  std::unique_ptr<Input> Drawn; // what the delegate drew, as a resource
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer; // that the delegate draws to
  vtkSmartPointer<vtkOpenGLFramebufferObject> Resolved;    // of one sample; nullptr if it is that
  vtkSmartPointer<vtkRenderbuffer> Samples[2];             // colour and depth, multisampled
  vtkSmartPointer<vtkTextureObject> Color;                 // of one sample, as it was drawn
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Linear[2]; // the first is the colour now
  vtkSmartPointer<vtkOpenGLFramebufferObject> Pen;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToDisplay;
  vtkRelievoScreenQuad Copy;
  int Size[4] = { 0, 0, 0, 0 }; // of the framebuffer, and of the viewport
  int NumberOfSamples = 0;
  DepthFormat DepthOf;
  bool Valid = false;
};

#endif
