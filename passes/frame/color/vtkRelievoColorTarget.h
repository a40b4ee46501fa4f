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

  // Makes the float framebuffer for what the delegate draws: of a single sample, or of as many as
  // what is bound for drawing has. Returns why it cannot, in words.
  std::string Prepare(vtkRelievoFrameContext& context, bool single);

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

  // Before End: puts what quads make, which are ready, in the place of what has been drawn in a
  // part of the viewport: linear colours, and depths.
  void Put(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& colors,
    vtkRelievoScreenQuad* depths, const int part[4]);

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

  // Copies the depth as it is to what is bound, if that is of one kind, once after each End;
  // otherwise Present writes it with the colour, and shaders that read `drawn` know by
  // RELIEVO_DEPTH_LEFT. To be called before those that present are made ready.
  bool PresentDepth(vtkRelievoFrameContext& context);

  // Writes the colour and the depth into the framebuffer that is bound, once after each End:
  // through the sRGB curve, or as the quad does, which is ready, with what it makes of the
  // background, if that is known; or as the quad does in a part alone, there perhaps only where
  // something is drawn. False if it was done before.
  bool Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad = nullptr,
    const float* background = nullptr, const int* part = nullptr, bool drawnOnly = false);

  // Adds the colour as the point array `color`, 4 float.
  std::string Read(vtkImageData* image);

  vtkIdType GetBytes() const { return this->Buffers.GetBytes(); }
  void Release(vtkWindow* window);

  ///@{
  // Where the delegate may have drawn: x, y, width, height; and what is outside, as it is kept.
  void GetDrawnPart(int part[4]) const;
  void GetBackground(const vtkRelievoFrameContext& context, float color[4]) const;
  ///@}

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
    static Rectangle Of(const int part[4]); // x, y, width, height
    Rectangle With(const Rectangle& other) const;
    Rectangle Within(const Rectangle& other) const;
    std::vector<Rectangle> Without(const Rectangle& inner) const; // that lies within it
  };

  using Rectangles = std::vector<Rectangle>;

  // Of the rectangles what lies outside the other.
  static Rectangles Outside(const Rectangles& all, const Rectangle& other);

  Rectangle GetAll() const;
  bool IsWhole() const; // the linear colour is there for every pixel
  void CopyWhatIsThere(vtkRelievoFrameContext& context, int framebuffer, bool resolves);
  void MakeLinear(vtkRelievoFrameContext& context, const Rectangle& where);
  void PresentBackground(vtkRelievoFrameContext& context, const float* color);
  void DrawOnto(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, int which, bool blends,
    const Rectangle& where);
  class Input;
  std::unique_ptr<Input> Drawn; // what the delegate drew, as a resource
  vtkRelievoColorBuffers Buffers;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToDisplay;
  vtkRelievoScreenQuad Copy;
  vtkRelievoScreenQuad ToDisplayAsDrawn;
  Rectangle Made;            // where the linear colour is there
  Rectangle DrawnOn;         // where the delegate may have drawn: outside is the background
  bool TellsByDepth = false; // see vtkRelievoDrawnPart
  bool Valid = false;
  bool Separated = false; // the linear colour was made before all was drawn
  bool Presented = false;
  bool DepthPresented = false;
};

#endif
