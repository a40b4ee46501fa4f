// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean of frames that differ in the stages' sample, for example of a light with a size: sums of
// the linear colour and of the lights' visibility, which restart when anything else changes.
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
  // Starts a picture, of one or several samples: its content is compared once.
  void BeginFrame() { this->Turns = 0; }

  // Selects the context's sample, for the needs of the planned nodes.
  void Begin(vtkRelievoFrameContext& context, const std::vector<vtkRelievoFramePlan::Node>& nodes,
    bool hasColor, const std::vector<vtkRelievoStage*>& stages);

  // After all stages but the display: adds the sample, and replaces the colour by the mean.
  void Accumulate(vtkRelievoFrameContext& context);

  // After the drawing, in which mappers may have marked themselves as modified.
  void End(const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages);

  // Whether the layer was gathered in the last frame; Read() adds its mean to the image.
  bool Has(const std::string& layer) const;
  std::string Read(const std::string& layer, vtkImageData* image);

  // Number of samples that the last picture, and the last frame's layers, still lack.
  int GetLeft() const;

  // The reason why the frame shows only its first sample; "" if there is none.
  const std::string& GetFault() const { return this->Fault; }

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  // A frame's requirements for gathering.
  struct Demand
  {
    int Samples = 1;      // total; 1: no gathering
    bool AtOnce = false;  // all in this frame, not one in each
    bool Offsets = false; // within the pixel
    bool Color = false;
    bool AnyRaster = false;          // all can be drawn at once, unless the scene has an obstacle
    std::vector<std::string> Layers; // lights' visibility, and stages' Gathered layers
  };
  struct Sum
  {
    vtkRelievoScreenTarget Target{ "relievoGathered" };
    vtkRelievoScreenQuad Quad;
    int Count = 0;
    int Weight = 0;    // weight of the sum: 1 if it is the mean of all
    bool There = true; // the frame makes the resource to add
    bool IsDrawnAtOnce() const { return this->Weight == 1 && this->Count > 1; }
    void Release(vtkWindow* window);
  };

  // Agreement of all processes that draw together: the least number of samples, a restart if any
  // process restarts, and the frame's last turn if it is the last for all.
  void AgreeOnSamples(vtkMultiProcessController* controller, bool& begins);
  static void AgreeOnLast(vtkRelievoFrameContext& context);

  static Demand GetDemand(const vtkRelievoFrameContext& context,
    const std::vector<vtkRelievoFramePlan::Node>& nodes, bool hasColor);
  void Choose(vtkRelievoFrameContext& context);
  void ReleaseSums(vtkWindow* window);
  void GiveUp(vtkRelievoFrameContext& context);
  std::string ShowMean(vtkRelievoFrameContext& context);
  std::string Add(vtkRelievoFrameContext& context, Sum& sum, const vtkRelievoResourceName& resource,
    const std::string& defines, int channels);

  Demand Asked;
  // Demand of the last frame, captures of one sample excluded.
  int Before = 1;
  bool OffsetsBefore = false;
  bool OneByOneBefore = false;
  int Turns = 0; // of this frame, this one included
  std::string Fault;
  vtkRelievoSceneFingerprint State;
  std::unique_ptr<Sum> Color;
  std::unique_ptr<vtkRelievoSampleLattice> Lattice;
  std::string Words;                   // description of its drawing
  std::optional<std::string> Obstacle; // the scene's obstacle to drawing all at once
  bool ColorOfPicture = false;         // not of a capture without the picture
  std::map<std::string, std::unique_ptr<Sum>> Layers;
  vtkRelievoScreenQuad Mean;
};

#endif
