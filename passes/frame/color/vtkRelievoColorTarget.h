// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `color`: the delegate's picture, unclamped, in linear light, premultiplied, in half
// floats, or in floats on software OpenGL.
//
// The delegate draws into a float framebuffer with the multisampling of the framebuffer that it
// replaces. Its colours, which VTK makes for display, are decoded by the inverse sRGB curve where
// stages change them. Present() encodes these by the curve into the framebuffer bound before, and
// copies the others, and the depth, unchanged. Shaders that read the colour decode unchanged
// colours themselves, see frame/color.glsl.
#ifndef vtkRelievoColorTarget_h
#define vtkRelievoColorTarget_h

#include "vtkRelievoColorBuffers.h"
#include "vtkRelievoFrameColor.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScreenQuad.h"

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoColorTarget
  : public vtkRelievoResource
  , public vtkRelievoFrameColor
{
public:
  vtkRelievoColorTarget();
  ~vtkRelievoColorTarget() override;

  // Makes the delegate's float framebuffer: single-sampled, or with the samples of the framebuffer
  // bound for drawing. Returns an error message, or an empty string.
  std::string Prepare(vtkRelievoFrameContext& context, bool single);

  // Binds the float framebuffer.
  void Begin(vtkRelievoFrameContext& context);

  // Whether the float framebuffer is bound for drawing, or for reading.
  bool IsBound(bool reading = false) const;

  ///@{
  // Before End(): makes the linear colour from the present drawing, without later drawing. Clear()
  // then clears to black with this alpha, and Resolve() makes the later drawing the resource
  // `drawn`.
  void Separate(vtkRelievoFrameContext& context);
  void Clear(vtkRelievoFrameContext& context, float alpha);
  void Resolve(vtkRelievoFrameContext& context);
  ///@}

  // Before End(): replaces the drawing in a part of the viewport by linear colours and depths from
  // quads that are ready.
  void Put(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& colors,
    vtkRelievoScreenQuad* depths, const int part[4]);

  // Restores the binding before Begin(); the linear colour is available from now on.
  void End(vtkRelievoFrameContext& context);

  ///@{
  // After End(): drawing between these calls is discarded.
  void BeginAside(vtkRelievoFrameContext& context);
  void EndAside(vtkRelievoFrameContext& context);
  ///@}

  bool Draw(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces,
    const int* part = nullptr) override;

  // Copies the depth to the bound framebuffer, if the formats match, once after each End();
  // otherwise Present() writes it with the colour, and shaders that read `drawn` learn this from
  // RELIEVO_DEPTH_LEFT. Must be called before the presenting quads are made ready.
  bool PresentDepth(vtkRelievoFrameContext& context);

  bool Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad = nullptr,
    const float* background = nullptr, const int* part = nullptr, bool drawnOnly = false) override;

  // Adds the colour as the point array `color`, 4 floats per pixel.
  std::string Read(vtkImageData* image);

  vtkIdType GetBytes() const { return this->Buffers.GetBytes(); }
  void Release(vtkWindow* window);

  void GetDrawnPart(int part[4]) const override;
  void GetBackground(const vtkRelievoFrameContext& context, float color[4]) const override;

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  // Pixels of the viewport, from the first (inclusive) to the last (exclusive).
  struct Rectangle
  {
    int From[2] = { 0, 0 };
    int To[2] = { 0, 0 };

    bool IsEmpty() const { return this->From[0] >= this->To[0] || this->From[1] >= this->To[1]; }
    static Rectangle Of(const int part[4]); // x, y, width, height
    Rectangle With(const Rectangle& other) const;
    Rectangle Within(const Rectangle& other) const;
    std::vector<Rectangle> Without(const Rectangle& inner) const; // `inner` lies within it
  };

  using Rectangles = std::vector<Rectangle>;

  // The rectangles' areas outside the other one.
  static Rectangles Outside(const Rectangles& all, const Rectangle& other);

  Rectangle GetAll() const;
  bool IsWhole() const; // the linear colour covers every pixel
  void CopyWhatIsThere(vtkRelievoFrameContext& context, int framebuffer, bool resolves);
  void MakeLinear(vtkRelievoFrameContext& context, const Rectangle& where);
  void PresentBackground(vtkRelievoFrameContext& context, const float* color);
  void DrawOnto(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, int which, bool blends,
    const Rectangle& where);
  class Input;
  std::unique_ptr<Input> Drawn; // the delegate's drawing as a resource
  vtkRelievoColorBuffers Buffers;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToDisplay;
  vtkRelievoScreenQuad Copy;
  vtkRelievoScreenQuad ToDisplayAsDrawn;
  Rectangle Made;            // area of the linear colour
  Rectangle DrawnOn;         // area that the delegate may have drawn to; outside is the background
  bool TellsByDepth = false; // see vtkRelievoDrawnPart
  bool Valid = false;
  bool Separated = false; // the linear colour was made before the drawing ended
  bool Presented = false;
  bool DepthPresented = false;
};

#endif
