// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One set of maps for processes that each hold a part of the scene. The first process fits the maps
// to what all of them cast and receive; each draws what it holds into them; the least depth over
// all is what every one looks up. Only maps that changed travel.
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

  // Whether there is anybody to exchange with. All that follows is called by every process.
  bool IsOn() const { return this->Controller && this->Controller->GetNumberOfProcesses() > 1; }
  bool IsRoot() const { return this->Controller->GetLocalProcessId() == 0; }

  // Of lights by their number in the renderer, those that every process names.
  std::vector<int> FindCommon(const std::vector<int>& lights);

  // Whether all processes say so.
  bool IsEverywhere(bool here);

  // Brings what casts and receives anywhere to the first process. Its view counts for all, and the
  // least of all processes' largest maps.
  void Gather(vtkRelievoShadowScene& scene);

  // Gives the first process's maps to all; `size` is set to theirs.
  void Share(
    vtkRelievoShadowCache& cache, const std::vector<vtkRelievoShadowLight>& casting, int& size);

  // A map that any process has lost is drawn anew by all.
  void Agree(vtkRelievoShadowCache& cache);

  // The map that was just drawn becomes that of all processes.
  void Merge(vtkRelievoShadowMaps& maps, int layer);

  double GetSeconds() const { return this->Seconds; }
  std::string GetReport() const;

private:
  void Broadcast(std::vector<double>& numbers);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  double Seconds = 0.0; // of the last frame that merged maps
  int Merged = 0;       // maps in it
  bool NewFrame = false;
  std::vector<float> Own;
  std::vector<float> Least;
};

#endif
