// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One frame while it is made: whose it is, what is asked of it, its camera, and what its stages
// have written so far.
#ifndef vtkRelievoFrameContext_h
#define vtkRelievoFrameContext_h

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoLampShadows.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;
class vtkOpenGLRenderWindow;
class vtkRelievoColorTarget;
class vtkRelievoFramePass;
class vtkRelievoResource;
class vtkRelievoSampleLattice;
class vtkRelievoScreenQuad;
class vtkRelievoScreenTarget;
class vtkRelievoStage;
class vtkRelievoTranslucentDepth;
class vtkRenderPass;
class vtkRenderState;
class vtkRenderer;

class VTKRELIEVOFRAME_EXPORT vtkRelievoFrameContext
{
public:
  vtkRelievoFramePass* Frame = nullptr;
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  const vtkRenderState* State = nullptr;
  vtkRelievoFrameCamera View;
  vtkRelievoFrameCamera SteadyView; // without the sample's offset within the pixel
  vtkRelievoFrameScene Scene;       // empty if no stage runs

  // Whether the window's picture is drawn; if not, only layers are, and the window does not change.
  bool Picture = true;

  // The pass that draws the picture; nullptr: the renderer's own steps.
  vtkRenderPass* Delegate = nullptr;

  // Whether the renderer's own steps draw the picture, without a pass.
  bool OwnSteps = true;

  // Another pass is around the frame's (ParaView's camera pass), and has cleared where it draws.
  bool Nested = false;

  // The processes that draw the frame together with this one, each its own props; or nullptr.
  vtkMultiProcessController* Controller = nullptr;

  // Layers that will be read back to the CPU.
  std::vector<std::string> ReadBack;

  // The linear colour is among the layers that are read, now or by a stage that shows it.
  bool ReadsColor = false;

  // Layers that are a light's visibility, and the light's index in vtkRenderer::GetLights().
  std::map<std::string, int> Lights;

  // Which sample of how many the stages draw that declare some, and whether the frame ends with
  // it: if not, nothing is shown yet, and the next one follows. Waits: nothing is to be shown
  // before all are there.
  int Sample = 0;
  int Samples = 1;
  bool Last = true;
  bool Waits = false;

  // Whether samples lie at different places within each pixel, for smooth edges.
  bool OffsetsSamples = false;

  // Where they lie, if the frame draws all of them at once, into a raster that is finer than the
  // pixels; otherwise nullptr.
  const vtkRelievoSampleLattice* Lattice = nullptr;

  // The lattice of the mean that is shown, in this frame and in those that show it again, and how
  // it was drawn, in words; nullptr and "" if samples were drawn one by one.
  const vtkRelievoSampleLattice* MeanLattice = nullptr;
  std::string MeanWords;
  bool OneByOne = false; // that could not be done, or is not wanted
  std::string Obstacle;  // what in the scene stands against it, in words

  // Lamps whose shadows are wanted, as the resource `lamp shadows`; from Prepare on.
  std::vector<vtkRelievoCastingLamp> CastingLamps;

  // Whether lights may come through what colours them: verdicts of a light are then not all that is
  // known of its shadows. From Prepare on.
  bool ColorsLight = false;

  // What is requested of the things that a stage writes; sorted. Empty if the stage is not needed.
  const std::vector<std::string>& GetAsked(const vtkRelievoStage* stage) const;
  bool IsAsked(const vtkRelievoStage* stage, const std::string& resource) const;

  // Whether some stage is asked for it in this frame.
  bool IsPlanned(const std::string& resource) const;

  ///@{
  // What a stage wrote, by the resource's name; nullptr if it does not exist (yet). It must live
  // until the frame is done.
  void Provide(const std::string& name, vtkRelievoResource* resource);
  vtkRelievoResource* Find(const std::string& name) const;

  // A layer that a stage wrote, by the name that users give it: an array may be called as a
  // resource is. nullptr if it does not exist (yet).
  void ProvideLayer(const std::string& name, vtkRelievoResource* resource);
  vtkRelievoResource* FindLayer(const std::string& name) const;
  ///@}

  // How far a depth from the z that the delegate leaves, which the resource `drawn` has, is from
  // the truth at most, in world units; infinite where a pixel has several samples.
  double GetDrawnDepthError(double depth) const;

  // Draws the quad, after its Ready, over the linear colour: as the new colour if `replaces`,
  // otherwise blended as OpenGL's state says. What blends does not read
  // `color`. Outside `part` of the viewport (x, y, width, height in pixels), if that is given, it
  // must change nothing: it is drawn there at most within the rectangle around the part and what
  // has been changed before. False if there is no linear colour.
  bool DrawColor(vtkRelievoScreenQuad& quad, bool replaces = true, const int* part = nullptr);

  ///@{
  // The part of the viewport (x, y, width, height in pixels) outside of which the delegate leaves
  // nothing but the renderer's background; without a linear colour it is empty. And that background
  // as it is kept, for display.
  void GetDrawnPart(int part[4]) const;
  void GetBackground(float color[4]) const;
  ///@}

  // Draws the quad, after its Ready, as the picture of the linear colour, in the place of the sRGB
  // curve alone; for stages that declare that they present. Its shader writes the depth as well
  // where frame/toDisplayFS.glsl does. `background`: what the
  // quad makes of the renderer's background, RGBA, if that is the same in every pixel; it need not
  // be drawn where nothing else is. False if there is no linear colour, or it is in the picture
  // already.
  bool Present(vtkRelievoScreenQuad& quad, const float* background = nullptr);

  ///@{
  // Whether the stage that runs is the last to work on the linear colour, and the picture is that
  // through the sRGB curve. It may then draw its quad, after its Ready, as the picture of a part of
  // the viewport, through the curve, in the place of DrawColor: the colour is not written to be
  // read once. Outside the part, and with `drawnOnly` where nothing is drawn, which may be left
  // out, the colour is shown as it is.
  bool FinishesColor() const { return this->Finishes; }
  bool PresentPart(vtkRelievoScreenQuad& quad, const int part[4], bool drawnOnly = false);
  ///@}

  // To be called in Prepare: what the delegate draws translucent, and volumes, are kept apart from
  // the colour, in the target: premultiplied, in linear light. If `putBack`, the colour has them as
  // well, blended as VTK does. After the delegate the resource `translucent` is the target if there
  // was anything to draw; otherwise the target is as it was, and need not be allocated.
  void KeepTranslucentApart(vtkRelievoScreenTarget* target, bool putBack);

  // To be called in Prepare: where something is kept apart, its depth is drawn as well, once for
  // all who want it, and is the resource `translucent depth`.
  void WantTranslucentDepth(vtkRelievoTranslucentDepth* depth);

  // Reads layers that earlier stages wrote: see vtkRelievoStage::ReadLayers.
  std::function<std::string(const std::vector<std::string>&, vtkImageData*)> ReadLayers;

private:
  friend class vtkRelievoFrameRun;
  friend class vtkRelievoTranslucentLayers;

  std::map<const vtkRelievoStage*, std::vector<std::string>> Asked;
  std::map<std::string, vtkRelievoResource*> Resources;
  std::map<std::string, vtkRelievoResource*> Layers;
  vtkRelievoColorTarget* Color = nullptr;
  bool Finishes = false;
  vtkRelievoScreenTarget* Translucent = nullptr;
  bool PutBack = false;
  vtkRelievoTranslucentDepth* TranslucentDepth = nullptr;
};

#endif
