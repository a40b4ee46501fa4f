// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stage's declaration of its work in one frame, made before the frame is planned.
#ifndef vtkRelievoDeclaration_h
#define vtkRelievoDeclaration_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoResourceName.h"

#include <string>
#include <vector>

struct VTKRELIEVOFRAME_EXPORT vtkRelievoDeclaration
{
  // Whether the stage has work to do; if not, ReasonCode and Reason tell why (vtkRelievoStage). A
  // stage that runs only for layers also sets them, for pictures that request none of its layers.
  // The reason of a "refused" stage is an error, which the frame reports once.
  bool Runs = true;
  std::string ReasonCode;
  std::string Reason;

  std::vector<vtkRelievoResourceName> Reads; // required inputs
  // Required inputs by their name for users: arrays and published layers.
  std::vector<std::string> ReadsLayers;
  std::vector<vtkRelievoResourceName> OptionalReads; // inputs that are read if they are offered
  // A writer of `color` changes it, whether it reads it or not.
  std::vector<vtkRelievoResourceName> Writes;
  std::vector<std::string> Layers; // outputs that users can also request by these names
  bool WritesArrays = false;       // and any layer that is in no stage's Layers
  // Subset of Writes: only for users that read them optionally.
  std::vector<vtkRelievoResourceName> OptionalWrites;
  // Layers of other stages that this one changes when they are read after the frame, and its own
  // layer that it needs for that. Its ReadLayers is given their names, and the image has them.
  std::vector<std::string> Amends;
  std::string AmendsBy;
  // Whether the stage changes the colour only in pictures in which an earlier stage does.
  bool OnlyIfColorChanges = false;
  // Whether the stage changes the colour only if translucent geometry is kept apart.
  bool OnlyIfTranslucent = false;
  bool HidesColor = true; // for a writer of `picture`: the colour is certainly hidden

  // Whether the stage takes part in the delegate's drawing: needed whenever the delegate is.
  bool DrawsWithDelegate = false;

  // Whether the stage makes the picture from the colour, by vtkRelievoFrameContext::Present, in
  // place of the sRGB curve. If it does not, the curve is used.
  bool Presents = false;

  // Number of samples, of which each frame draws one (vtkRelievoFrameContext::Sample) while nothing
  // else changes; the frame gathers lights' visibility, and the colour if an OptionalWrites is
  // requested, and shows the mean. AtOnce: every frame draws all samples. OffsetsSamples: samples
  // have different positions within each pixel. Gathered: further outputs that are means of
  // samples: `color`, and layers of one channel.
  int Samples = 1;
  std::vector<vtkRelievoResourceName> Gathered;
  bool AtOnce = false;
  bool OffsetsSamples = false;
  // Whether the stage also works if all samples are drawn at once, in a raster finer than the
  // pixels (vtkRelievoFrameContext::Lattice): its spliced shader code must not read textures by
  // pixel.
  bool AnyRaster = false;
};

#endif
