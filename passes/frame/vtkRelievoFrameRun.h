// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes one frame: plans which stages run, and runs them around the delegate.
#ifndef vtkRelievoFrameRun_h
#define vtkRelievoFrameRun_h

#include "vtkRelievoFramePlan.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkRelievoColorTarget;
class vtkRelievoDelegate;
class vtkRelievoFrameContext;
class vtkRelievoSampleAccumulator;
class vtkRelievoSampleRaster;
class vtkRelievoFrameReport;
class vtkRelievoGpuTimer;
class vtkRelievoHiddenPoints;
class vtkRelievoStage;
class vtkRelievoTranslucentLayers;
class vtkRenderPass;

class vtkRelievoFrameRun
{
public:
  vtkRelievoFrameRun(vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages,
    vtkRelievoColorTarget& color, vtkRelievoTranslucentLayers& translucent,
    vtkRelievoSampleAccumulator& samples, vtkRelievoSampleRaster& raster,
    vtkRelievoGpuTimer& timer);

  ///@{
  // The phases of a frame, to be called in this order.

  // Stages learn of each other's processes what they have to know before they declare.
  void Synchronize();

  // Stages say what they would read and write.
  void Declare();

  // Works out what runs, and tells the others why not. Returns what cannot run for what it reads.
  std::vector<std::string> Plan();

  // What the plan needs is made ready; a stage may still find that it cannot run.
  void Prepare();

  // Stages that draw for lights.
  void DrawLightMaps();

  // VTK's own picture. Delegates draw in one go, so it is interrupted where a later phase must come
  // first: what lies over the picture (texts, bars) waits for DrawStages and Present. Returns the
  // number of props that the delegate drew.
  int DrawDelegate(vtkRelievoDelegate& delegate, vtkRenderPass* pass);

  // Stages that follow the surfaces, up to the finished linear colour; once.
  void DrawStages();

  // Samples are accumulated, stages show what they show, and the colour becomes the picture; once.
  void Present();

  // Stages let go of the frame, in the opposite order.
  void Finish();
  ///@}

  bool NeedsColor() const { return this->Planned.NeedsColor(); }
  // What was done and why; the pass is the delegate.
  void Report(vtkRelievoFrameReport& report, vtkRenderPass* pass) const;

  bool IsNeeded(const vtkRelievoStage* stage) const;

  // Who writes the layers that were asked for in this frame; "" is who writes any other.
  std::map<std::string, vtkRelievoStage*> GetWriters() const;

  // Layers that were asked for and cannot be made, and why, in words.
  const std::map<std::string, std::string>& GetMissing() const
  {
    return this->Planned.GetMissing();
  }

private:
  void FindLights();
  std::vector<vtkRelievoStage*> GetRunning() const;
  void RunStages(int lastSlot);
  void Run(int place);
  bool FinishesColor() const;
  void PresentColor();
  void CheckRaster();
  using HiddenPoints = std::vector<std::unique_ptr<vtkRelievoHiddenPoints>>;
  void FindHidden(HiddenPoints& hidden) const;

  vtkRelievoFrameContext& Context;
  const std::vector<vtkRelievoStage*>& Stages; // node i + 1 is stage i
  vtkRelievoColorTarget& Color;
  vtkRelievoTranslucentLayers& Translucent;
  vtkRelievoSampleAccumulator& Samples;
  vtkRelievoSampleRaster& Raster;
  vtkRelievoGpuTimer& Timer;
  vtkRelievoFramePlan Planned;
  std::vector<vtkRelievoFramePlan::Node> Nodes; // the first is the delegate
  std::vector<bool> WorkOnColor;                // of Nodes: read, change or present it
  std::vector<bool> Dropped;                    // of Nodes: needed, and cannot run after all
  std::size_t Next = 0;                         // in the order
  bool ColorOpen = false;                       // the delegate draws into the colour target
  bool StagesDrawn = false;
  bool Presented = false;
};

#endif
