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
class vtkRelievoPointGroups;
class vtkRelievoStage;
class vtkRelievoTranslucentLayers;
class vtkRenderPass;

class vtkRelievoFrameRun
{
public:
  vtkRelievoFrameRun(vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages,
    vtkRelievoColorTarget& color, vtkRelievoTranslucentLayers& translucent,
    vtkRelievoSampleAccumulator& samples, vtkRelievoSampleRaster& raster,
    vtkRelievoPointGroups& pointGroups, vtkRelievoGpuTimer& timer);

  ///@{
  // The phases of a frame, to be called in this order.

  // Stages exchange data with other processes, before they declare.
  void Synchronize();

  // Stages declare their inputs and outputs.
  void Declare();

  // Plans the stages to run, and sets the others' reasons. Returns messages about missing inputs.
  std::vector<std::string> Plan();

  // Prepares the planned stages; a stage may still find that it cannot run.
  void Prepare();

  // Runs the stages that draw for lights.
  void DrawLightMaps();

  // Draws VTK's own picture. Delegates draw in one go, so the frame interrupts them where a later
  // phase must come first: the overlay (texts, bars) waits for DrawStages() and Present(). Returns
  // the number of props that the delegate drew.
  int DrawDelegate(vtkRelievoDelegate& delegate, vtkRenderPass* pass);

  // Runs the stages after the surfaces, up to the finished linear colour; once.
  void DrawStages();

  // Accumulates samples, runs display stages, and presents the colour as the picture; once.
  void Present();

  // Finishes the stages, in reverse order.
  void Finish();
  ///@}

  bool NeedsColor() const { return this->Planned.NeedsColor(); }
  // Fills the report; the pass is the delegate.
  void Report(vtkRelievoFrameReport& report, vtkRenderPass* pass) const;

  bool IsNeeded(const vtkRelievoStage* stage) const;

  // The writers of the layers requested in this frame; "" is the writer of any other layer.
  std::map<std::string, vtkRelievoStage*> GetWriters() const;

  // The stages that change layers of others when they are read.
  std::map<std::string, vtkRelievoStage*> GetAmenders() const;

  // Requested layers that cannot be made, and the reasons.
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
  vtkRelievoPointGroups& PointGroups;
  vtkRelievoGpuTimer& Timer;
  vtkRelievoFramePlan Planned;
  std::vector<vtkRelievoFramePlan::Node> Nodes; // the first is the delegate
  std::vector<bool> WorkOnColor;                // of Nodes: read, change or present it
  std::vector<bool> Dropped;                    // of Nodes: needed, but unable to run
  std::size_t Next = 0;                         // in the order
  bool ColorOpen = false;                       // the delegate draws into the colour target
  bool StagesDrawn = false;
  bool Presented = false;
};

#endif
