// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The linear colour of a frame, as its context offers it to stages.
#ifndef vtkRelievoFrameColor_h
#define vtkRelievoFrameColor_h

class vtkRelievoFrameContext;
class vtkRelievoScreenQuad;

class vtkRelievoFrameColor
{
public:
  virtual ~vtkRelievoFrameColor() = default;

  // Draws the quad, which is ready, over the linear colour: as the new colour, or blended,
  // optionally over a part only.
  virtual bool Draw(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces,
    const int* part = nullptr) = 0;

  // Writes the colour and the depth into the bound framebuffer, once after the drawing has ended:
  // through the sRGB curve, or by the quad, which is ready; `background` is the quad's colour of
  // the background, if known. With a part, the quad applies only there, with `drawnOnly` perhaps
  // only at drawn pixels. False if the colour was presented before.
  virtual bool Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad = nullptr,
    const float* background = nullptr, const int* part = nullptr, bool drawnOnly = false) = 0;

  ///@{
  // The part that the delegate may have drawn to: x, y, width, height; and the background outside
  // it.
  virtual void GetDrawnPart(int part[4]) const = 0;
  virtual void GetBackground(const vtkRelievoFrameContext& context, float color[4]) const = 0;
  ///@}
};

#endif
