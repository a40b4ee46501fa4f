// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean of frames that differ in the sample that stages draw, of lights with a size for one:
// sums of the linear colour and of the lights' visibility, which begin anew when anything else
// changes.
#ifndef vtkRelievoSampleAccumulator_h
#define vtkRelievoSampleAccumulator_h

#include "vtkRelievoFramePlan.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoSceneFingerprint.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;
class vtkRelievoFrameContext;
class vtkRelievoStage;
class vtkWindow;

class vtkRelievoSampleAccumulator
{
public:
  // A picture begins, of one sample or of many: what it shows is compared once.
  void BeginFrame() { this->Turns = 0; }

  // Chooses the context's sample, for what the planned nodes need.
  void Begin(vtkRelievoFrameContext& context, const std::vector<vtkRelievoFramePlan::Node>& nodes,
    bool hasColor, const std::vector<vtkRelievoStage*>& stages);

  // When all but the display has been made: adds the sample, and makes the colour the mean.
  void Accumulate(vtkRelievoFrameContext& context);

  // When it is drawn: mappers may have counted themselves as modified.
  void End(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Whether the layer was gathered in the last frame; adds its mean to the image.
  bool Has(const std::string& layer) const;
  std::string Read(const std::string& layer, vtkImageData* image);

  // Samples that the last picture, and the layers of the last frame, are still short of.
  int GetLeft() const;

  // Why the frame shows its first sample alone, in words; "": it does not.
  const std::string& GetFault() const { return this->Fault; }

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  // What a frame is to gather.
  struct Demand
  {
    int Samples = 1;      // in all; 1: nothing
    bool AtOnce = false;  // in this frame, not one in each
    bool Offsets = false; // within the pixel
    bool Color = false;
    bool AnyRaster = false; // all can be drawn at once, if nothing in the scene stands against it
    std::vector<std::string> Layers; // lights' visibility, and what stages say
  };
  struct Sum
  {
    vtkRelievoScreenTarget Target{ "relievoGathered" };
    vtkRelievoScreenQuad Quad;
    int Count = 0;
    int Weight = 0;    // of the sum: 1 if it is the mean of all
    bool There = true; // the frame makes what is to be added
    bool IsDrawnAtOnce() const { return this->Weight == 1 && this->Count > 1; }
    void Release(vtkWindow* window);
  };

  // What all processes that draw together do: as many samples as the least of them, begun again if
  // any of them begins; and the frame's last turn, if it is that of all.
  void AgreeOnSamples(vtkMultiProcessController* controller, bool& begins);
  static void AgreeOnLast(vtkRelievoFrameContext& context);

  static Demand GetDemand(const vtkRelievoFrameContext& context,
    const std::vector<vtkRelievoFramePlan::Node>& nodes, bool hasColor);
  void Choose(vtkRelievoFrameContext& context);
  void ReleaseSums(vtkWindow* window);
  void GiveUp(vtkRelievoFrameContext& context);
  std::string ShowMean(vtkRelievoFrameContext& context);
  std::string Add(vtkRelievoFrameContext& context, Sum& sum, const std::string& resource,
    const std::string& defines, int channels);

  Demand Asked;
  // What the last frame was asked for, captures of one sample apart.
  int Before = 1;
  bool OffsetsBefore = false;
  bool OneByOneBefore = false;
  int Turns = 0; // of this frame, this one included
  std::string Fault;
  vtkRelievoSceneFingerprint State;
  std::unique_ptr<Sum> Color;
  std::unique_ptr<vtkRelievoSampleLattice> Lattice;
  std::string Words;                   // how the mean was drawn with it
  std::optional<std::string> Obstacle; // what in the scene keeps all from being drawn at once
  bool ColorOfPicture = false;         // not of a capture without the picture
  std::map<std::string, std::unique_ptr<Sum>> Layers;
  vtkRelievoScreenQuad Mean;
};

#endif
