// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Separates the delegate's translucent surfaces and volumes from the linear colour.
//
// When the delegate reaches translucent geometry, the linear colour is made from the drawing so
// far, and its framebuffer is cleared, except the depth. Each translucent step of VTK thus blends a
// premultiplied layer over an empty buffer, and the layers are composited in linear light.
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
  // Whether layers are needed only for the alpha of the colour, which is read: VTK before 9.3
  // leaves a wrong one.
  static bool RightsAlpha(const vtkRelievoFrameContext& context);

  // For one frame, while the delegate draws into the colour's framebuffer, by the context's
  // settings (KeepTranslucentApart, WantTranslucentDepth); without them all layers go back into the
  // colour.
  void Begin(vtkRelievoFrameContext& context, vtkRelievoColorTarget& color);

  ///@{
  // Starts the next phase. Ask() is called if the delegate asks which props are translucent, which
  // not all do; `sentinel` has the keys of the passes that draw.
  void Ask();
  void BeginSurfaces(vtkProp* sentinel);
  void BeginVolumes();
  ///@}

  // The delegate has drawn its translucent geometry.
  void End();

  void Release(vtkWindow* window);

private:
  void Open();
  void Close();

  vtkRelievoFrameContext* Context = nullptr;
  vtkRelievoColorTarget* Color = nullptr;
  vtkRelievoScreenQuad ToLinear;
  vtkRelievoScreenQuad ToColor;
  bool Any = false;      // a layer was opened in this frame
  bool IsOpen = false;   // the drawing goes to a layer
  bool Drawn = false;    // the layer has content
  bool Averaged = false; // by VTK's weighted average, with an alpha of its own
};

#endif
