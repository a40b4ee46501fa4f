// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `color`: what the delegate draws, unclamped, in linear light, premultiplied,
// in half floats, or in floats where OpenGL draws with the processor.
//
// The delegate draws into a float framebuffer in the place of the one that was bound, of the same
// multisampling; its colours, which VTK makes for display, go through the inverse of the sRGB curve
// where stages change them, and Present puts those through the curve into the framebuffer that was
// bound before, the others as they were drawn, with the depth. Shaders that read the colour make it
// of what was drawn where it has not been changed, see frame/color.glsl.
#ifndef vtkRelievoColorTarget_h
#define vtkRelievoColorTarget_h

#include "vtkRelievoColorBuffers.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScreenQuad.h"

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoColorTarget : public vtkRelievoResource
{
public:
  vtkRelievoColorTarget();
  ~vtkRelievoColorTarget() override;

  // Makes the float framebuffer for what the delegate draws. Returns why it cannot, in words.
  std::string Prepare(vtkRelievoFrameContext& context);

  // Binds it.
  void Begin(vtkRelievoFrameContext& context);

  // Whether what is bound for drawing, or for reading, now is what Begin bound.
  bool IsBound(bool reading = false) const;

  ///@{
  // Before End: the linear colour is made of what has been drawn until now, and what is drawn next
  // is not part of it. Clear makes room for that: black, with this alpha. Resolve makes it the
  // resource `drawn`.
  void Separate(vtkRelievoFrameContext& context);
  void Clear(vtkRelievoFrameContext& context, float alpha);
  void Resolve(vtkRelievoFrameContext& context);
  ///@}

  // Binds what was bound before Begin; the linear colour is there from now on.
  void End(vtkRelievoFrameContext& context);

  ///@{
  // After End: what is drawn between these is seen nowhere.
  void BeginAside(vtkRelievoFrameContext& context);
  void EndAside(vtkRelievoFrameContext& context);
  ///@}

  // Draws the quad, which is ready, over the linear colour: as the new colour, or blended,
  // also over a part only.
  bool Draw(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces,
    const int* part = nullptr);

  // Writes the colour and the depth into the framebuffer that is bound, once after each End:
  // through the sRGB curve, or as the quad does, which is ready. False if it was done before.
  bool Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad = nullptr);

  // Adds the colour as the point array `color`, 4 float.
  std::string Read(vtkImageData* image);

  vtkIdType GetBytes() const { return this->Buffers.GetBytes(); }
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  // Pixels of the viewport, from the first ones to those beyond the last.
  struct Rectangle
  {
    int From[2] = { 0, 0 };
    int To[2] = { 0, 0 };

    bool IsEmpty() const { return this->From[0] >= this->To[0] || this->From[1] >= this->To[1]; }
    Rectangle With(const Rectangle& other) const;
    std::vector<Rectangle> Without(const Rectangle& inner) const; // that lies within it
  };

  Rectangle GetAll() const;
  bool IsWhole() const; // the linear colour is there for every pixel
  void CopyWhatIsThere(vtkRelievoFrameContext& context, int framebuffer);
  void MakeLinear(vtkRelievoFrameContext& context, const Rectangle& where);
  void DrawOnto(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, int which, bool blends,
    const Rectangle& where);
  bool PresentDepth(vtkRelievoFrameContext& context);

  class Input;
  std::unique_ptr<Input> Drawn; // what the delegate drew, as a resource
  vtkRelievoColorBuffers Buffers;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToDisplay;
  vtkRelievoScreenQuad Copy;
  vtkRelievoScreenQuad ToDisplayAsDrawn;
  Rectangle Made; // where the linear colour is there
  bool Valid = false;
  bool Separated = false; // the linear colour was made before all was drawn
  bool Presented = false;
};

#endif
