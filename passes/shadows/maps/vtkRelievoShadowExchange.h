// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Common maps for processes that each hold a part of the scene. The first process fits the maps to
// the casters and receivers of all; each draws its own casters into them; the smallest depth over
// all processes is the result for every one. Only changed maps are sent.
#ifndef vtkRelievoShadowExchange_h
#define vtkRelievoShadowExchange_h

#include "vtkMultiProcessController.h"
#include "vtkRelievoShadowCache.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoShadowMaps;

class vtkRelievoShadowExchange
{
public:
  void SetController(vtkMultiProcessController* controller) { this->Controller = controller; }
  vtkMultiProcessController* GetController() const { return this->Controller; }

  // Whether there are other processes. All following functions are collective.
  bool IsOn() const { return this->Controller && this->Controller->GetNumberOfProcesses() > 1; }
  bool IsRoot() const { return this->Controller->GetLocalProcessId() == 0; }

  // Light numbers in the renderer listed by every process.
  std::vector<int> FindCommon(const std::vector<int>& lights);

  // Whether the argument is true on all processes.
  bool IsEverywhere(bool here);

  // Collects the casters and receivers of all processes on the first one. Uses its view, and the
  // smallest of all processes' largest maps.
  void Gather(vtkRelievoShadowScene& scene);

  // Sends the first process's maps to all; sets `size` to theirs.
  void Share(
    vtkRelievoShadowCache& cache, const std::vector<vtkRelievoShadowLight>& casting, int& size);

  // Marks maps lost on any process for redrawing on all.
  void Agree(vtkRelievoShadowCache& cache);

  // Merges the map drawn last over all processes.
  void Merge(vtkRelievoShadowMaps& maps, int layer);

  double GetSeconds() const { return this->Seconds; }
  std::string GetReport() const;

private:
  void Broadcast(std::vector<double>& numbers);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  double Seconds = 0.0; // in the last frame that merged maps
  int Merged = 0;       // maps merged in it
  bool NewFrame = false;
  std::vector<float> Own;
  std::vector<float> Least;
};

#endif
