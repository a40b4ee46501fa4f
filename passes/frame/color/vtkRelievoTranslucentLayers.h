// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keeps what the delegate draws translucent, and volumes, apart from the linear colour.
//
// When the delegate comes to them, the linear colour is made of what has been drawn, and its
// framebuffer is cleared, but for the depth. So each step of VTK's, whichever it is, blends a layer
// over nothing, premultiplied, which goes over the layers before in linear light.
#ifndef vtkRelievoTranslucentLayers_h
#define vtkRelievoTranslucentLayers_h

#include "vtkRelievoScreenQuad.h"

class vtkProp;
class vtkRelievoColorTarget;
class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoTranslucentLayers
{
public:
  // Whether layers are needed for the alpha of the colour alone, which is read: before 9.3 VTK
  // leaves another one.
  static bool RightsAlpha(const vtkRelievoFrameContext& context);

  // For a frame, while the delegate draws into the colour's framebuffer, as the context has been
  // told (KeepTranslucentApart, WantTranslucentDepth); else all goes back into the colour.
  void Begin(vtkRelievoFrameContext& context, vtkRelievoColorTarget& color);

  ///@{
  // What comes now. A delegate asks which props are translucent before it draws these, or it does
  // not; `sentinel` has the keys of the passes that draw.
  void Ask();
  void BeginSurfaces(vtkProp* sentinel);
  void BeginVolumes();
  ///@}

  // The delegate draws no more of them.
  void End();

  void Release(vtkWindow* window);

private:
  void Open();
  void Close();

  vtkRelievoFrameContext* Context = nullptr;
  vtkRelievoColorTarget* Color = nullptr;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToColor;
  bool Any = false;      // a layer has been opened in this frame
  bool IsOpen = false;   // what is drawn goes to a layer
  bool Drawn = false;    // something has been drawn into it
  bool Averaged = false; // by VTK's weighted average, which has an alpha of its own
};

#endif
