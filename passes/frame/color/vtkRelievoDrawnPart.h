// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the delegate may draw: elsewhere is the renderer's background and nothing else, so that no
// pixel there has to be looked at.
#ifndef vtkRelievoDrawnPart_h
#define vtkRelievoDrawnPart_h

class vtkRelievoFrameContext;

struct vtkRelievoDrawnPart
{
  // Pixels of the viewport around the props' boxes: x, y, width, height; 0 if there are none. The
  // whole viewport where something may be drawn outside its prop's box, such as glyphs, volumes, a
  // skybox, composite data, or a pass of one's own, and where the background has not one colour.
  int Part[4] = { 0, 0, 0, 0 };

  // Whether z is below 1 wherever something is drawn.
  bool TellsByDepth = false;

  void Find(const vtkRelievoFrameContext& context);
};

#endif
