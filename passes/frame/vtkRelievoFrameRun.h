// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes one frame: plans which stages run, and runs them around the delegate.
#ifndef vtkRelievoFrameRun_h
#define vtkRelievoFrameRun_h

#include "vtkRelievoFramePlan.h"

#include <map>
#include <string>
#include <vector>

class vtkRelievoColorTarget;
class vtkRelievoDelegate;
class vtkRelievoFrameContext;
class vtkRelievoSampleAccumulator;
class vtkRelievoFrameReport;
class vtkRelievoGpuTimer;
class vtkRelievoStage;
class vtkRelievoTranslucentLayers;
class vtkRenderPass;

class vtkRelievoFrameRun
{
public:
  vtkRelievoFrameRun(vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages,
    vtkRelievoColorTarget& color, vtkRelievoTranslucentLayers& translucent,
    vtkRelievoSampleAccumulator& gather, vtkRelievoGpuTimer& timer);

  // Works out what runs, and tells the others why not. Returns what cannot run for what it reads.
  std::vector<std::string> Plan();

  // Runs it; the number of props that the delegate drew.
  int Execute(vtkRelievoDelegate& delegate, vtkRenderPass* pass);

  bool NeedsColor() const { return this->Order.NeedsColor(); }
  // What was done and why; the pass is the delegate.
  void Report(vtkRelievoFrameReport& report, vtkRenderPass* pass) const;

  bool IsNeeded(const vtkRelievoStage* stage) const;

  // Who writes the layers that were asked for in this frame; "" is who writes any other.
  std::map<std::string, vtkRelievoStage*> GetWriters() const;

  // Layers that were asked for and cannot be made, and why, in words.
  const std::map<std::string, std::string>& GetMissing() const { return this->Order.GetMissing(); }

private:
  void Declare();
  void FindLights();
  void ExecuteStage(int place);
  void ExecuteRest();
  void FinishColor();
  void Present();
  int DrawDelegate(vtkRelievoDelegate& delegate, vtkRenderPass* pass);

  vtkRelievoFrameContext& Context;
  const std::vector<vtkRelievoStage*>& Stages; // node i + 1 is stage i
  vtkRelievoColorTarget& Color;
  vtkRelievoTranslucentLayers& Translucent;
  vtkRelievoSampleAccumulator& Gather;
  vtkRelievoGpuTimer& Timer;
  vtkRelievoFramePlan Order;
  std::vector<vtkRelievoFramePlan::Node> Nodes; // the first is the delegate
  std::vector<bool> Dropped;                    // of Nodes: needed, and cannot run after all
  std::size_t Next = 0;                         // in the order
  bool Gathered = false;
  bool ColorOpen = false; // the delegate draws into the colour target
};

#endif
