// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the viewport that the delegate may draw to. The rest shows only the renderer's
// background, so that its pixels need no processing.
#ifndef vtkRelievoDrawnPart_h
#define vtkRelievoDrawnPart_h

class vtkRelievoFrameContext;

struct vtkRelievoDrawnPart
{
  // Rectangle around the props' boxes in pixels of the viewport: x, y, width, height; 0 without
  // props. The whole viewport if props may draw outside their boxes (glyphs, volumes, a skybox,
  // composite data, or a user's pass), or if the background has several colours.
  int Part[4] = { 0, 0, 0, 0 };

  // Whether z is below 1 at every drawn pixel.
  bool TellsByDepth = false;

  void Find(const vtkRelievoFrameContext& context);
};

#endif
