// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The state of one frame: its renderer, requested outputs and camera, and the stages' output so
// far.
#ifndef vtkRelievoFrameContext_h
#define vtkRelievoFrameContext_h

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoLampShadows.h"
#include "vtkRelievoResourceName.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;
class vtkOpenGLRenderWindow;
class vtkRelievoFrameColor;
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

  // Whether the window's picture is drawn; if not, only layers are made, and the window does not
  // change.
  bool Picture = true;

  // The pass that draws the picture; nullptr: the renderer's own steps.
  vtkRenderPass* Delegate = nullptr;

  // Whether the renderer's own steps draw the picture, or a pass that draws like them.
  bool OwnSteps = true;

  // The frame is inside another pass (ParaView's camera pass), which has cleared its framebuffer.
  bool Nested = false;

  // The processes that draw the frame together, each its own props; nullptr for one process.
  vtkMultiProcessController* Controller = nullptr;

  // Layers to be read back to the CPU.
  std::vector<std::string> ReadBack;

  // Layers to be read back, too, if the other outputs need their stages.
  std::vector<std::string> OptionalLayers;

  // Stages may amend layers of others.
  bool Amends = true;

  // The linear colour is read as a layer, by the user or by a stage that shows it.
  bool ReadsColor = false;

  // Layers of a light's visibility, and the light's index in vtkRenderer::GetLights().
  std::map<std::string, int> Lights;

  // The present sample and the number of samples of stages that declare several, and whether it is
  // the frame's last: if not, nothing is shown yet, and the next one follows. Waits: nothing is
  // shown before all samples are drawn.
  int Sample = 0;
  int Samples = 1;
  bool Last = true;
  bool Waits = false;

  // Whether samples have different positions within each pixel, for smooth edges.
  bool OffsetsSamples = false;

  // The samples' positions, if the frame draws all of them at once, into a raster finer than the
  // pixels; otherwise nullptr.
  const vtkRelievoSampleLattice* Lattice = nullptr;

  // The lattice of the mean that is shown, in this frame and in those that repeat it, and a
  // description of its drawing; nullptr and "" if samples were drawn one by one.
  const vtkRelievoSampleLattice* MeanLattice = nullptr;
  std::string MeanWords;
  bool OneByOne = false; // drawing at once has failed, or is not wanted
  std::string Obstacle;  // the obstacle in the scene, in words

  // Lamps with requested shadows, which the resource `lamp shadows` has; from Prepare on.
  std::vector<vtkRelievoCastingLamp> CastingLamps;

  // Whether lights may pass through coloured surfaces, so that a light's visibility does not
  // describe its shadows completely. From Prepare on.
  bool ColorsLight = false;

  // The requested outputs of a stage, sorted. Empty if the stage is not needed.
  const std::vector<std::string>& GetAsked(const vtkRelievoStage* stage) const;
  bool IsAsked(const vtkRelievoStage* stage, const vtkRelievoResourceName& resource) const;
  bool IsLayerAsked(const vtkRelievoStage* stage, const std::string& name) const;

  // Whether the resource is requested from some stage in this frame.
  bool IsPlanned(const vtkRelievoResourceName& resource) const;

  ///@{
  // A stage's output, by the resource's name; nullptr if it does not exist (yet). The resource must
  // live until the end of the frame.
  void Provide(const vtkRelievoResourceName& name, vtkRelievoResource* resource);
  vtkRelievoResource* Find(const vtkRelievoResourceName& name) const;

  // A layer written by a stage, by its name for users: an array may have the name of a resource.
  // nullptr if it does not exist (yet).
  void ProvideLayer(const std::string& name, vtkRelievoResource* resource);
  vtkRelievoResource* FindLayer(const std::string& name) const;
  ///@}

  // Upper bound of the error of a depth from the delegate's z (the resource `drawn`), in world
  // units; infinite if pixels have several samples.
  double GetDrawnDepthError(double depth) const;

  // Draws the quad, after its Ready(), over the linear colour: as the new colour if `replaces`,
  // otherwise blended by OpenGL's present state. A blended quad must not read `color`. The quad
  // must change nothing outside `part` of the viewport (x, y, width, height in pixels), if given:
  // it is drawn at most within the rectangle around the part and earlier changes. False if there is
  // no linear colour.
  bool DrawColor(vtkRelievoScreenQuad& quad, bool replaces = true, const int* part = nullptr);

  ///@{
  // The part of the viewport (x, y, width, height in pixels) outside of which the delegate leaves
  // only the renderer's background; empty without a linear colour. GetBackground() returns that
  // background's stored colour, for display.
  void GetDrawnPart(int part[4]) const;
  void GetBackground(float color[4]) const;
  ///@}

  // Draws the quad, after its Ready(), as the picture of the linear colour, in place of the sRGB
  // curve; for stages whose declaration says that they present. Its shader also writes the depth in
  // the cases of frame/toDisplayFS.glsl. `background`: the quad's RGBA for the renderer's
  // background, if that is constant; areas with only background may then be skipped. False if there
  // is no linear colour, or it is in the picture already.
  bool Present(vtkRelievoScreenQuad& quad, const float* background = nullptr);

  ///@{
  // Whether the running stage is the last one to process the linear colour, and the picture is that
  // colour through the sRGB curve. The stage may then draw its quad, after its Ready(), as the
  // picture of a part of the viewport, through the curve, in place of DrawColor(), which saves
  // writing and reading the colour. Outside the part, and with `drawnOnly` at undrawn pixels, which
  // may be skipped, the colour is shown unchanged.
  bool FinishesColor() const { return this->Finishes; }
  bool PresentPart(vtkRelievoScreenQuad& quad, const int part[4], bool drawnOnly = false);
  ///@}

  // Call in Prepare(): keeps the delegate's translucent surfaces and volumes apart from the colour,
  // in the target: premultiplied, in linear light. With `putBack`, the colour contains them as
  // well, blended as by VTK. After the delegate the resource `translucent` is the target if there
  // was translucent geometry; otherwise the target is unchanged, and need not be allocated.
  void KeepTranslucentApart(vtkRelievoScreenTarget* target, bool putBack);

  // Call in Prepare(): if translucent geometry is kept apart, also draws its depth, once for all
  // callers, as the resource `translucent depth`.
  void WantTranslucentDepth(vtkRelievoTranslucentDepth* depth);

  // Reads layers written by earlier stages: see vtkRelievoStage::ReadLayers.
  std::function<std::string(const std::vector<std::string>&, vtkImageData*)> ReadLayers;

private:
  friend class vtkRelievoFrameRun;
  friend class vtkRelievoTranslucentLayers;

  std::map<const vtkRelievoStage*, std::vector<std::string>> Asked;
  std::map<std::string, vtkRelievoResource*> Resources;
  std::map<std::string, vtkRelievoResource*> Layers;
  vtkRelievoFrameColor* Color = nullptr;
  bool Finishes = false;
  vtkRelievoScreenTarget* Translucent = nullptr;
  bool PutBack = false;
  vtkRelievoTranslucentDepth* TranslucentDepth = nullptr;
};

#endif
