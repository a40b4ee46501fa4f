// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkRelievoFramePass holds beside its settings.
#ifndef vtkRelievoFrameInternals_h
#define vtkRelievoFrameInternals_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoColorTarget.h"
#include "vtkRelievoDelegate.h"
#include "vtkRelievoFrameGather.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoFrameReader.h"
#include "vtkRelievoFrameReport.h"
#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoTranslucentLayers.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

class vtkRelievoFramePass::Internals
{
public:
  vtkSmartPointer<vtkRenderPass> Delegate;
  std::vector<vtkSmartPointer<vtkRelievoStage>> Registered;
  std::vector<vtkSmartPointer<vtkRelievoStage>> Added;
  std::set<std::string> Requested;
  std::set<std::string> Said; // what could not be had, told once
  vtkRelievoGpuTimer Timer;
  vtkRelievoFrameReport Report;
  vtkRelievoDelegate Picture;
  vtkRelievoColorTarget Color;
  vtkRelievoTranslucentLayers Translucent;
  vtkRelievoFrameGather Gather;
  vtkRelievoFrameReader Reader{ Color, Gather };
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last frame

  std::vector<vtkRelievoStage*> GetStages()
  {
    std::vector<vtkRelievoStage*> stages;
    for (auto& stage : this->Registered)
    {
      const std::string name = stage->GetStageName();
      const bool replaced = std::any_of(this->Added.begin(), this->Added.end(),
        [&name](const auto& added) { return added->GetStageName() == name; });
      if (!replaced)
      {
        stages.push_back(stage);
      }
    }
    for (auto& stage : this->Added)
    {
      stages.push_back(stage);
    }
    return stages;
  }

  // A stage that leaves the frame: what it holds is released, and what it wrote is read no more.
  void Forget(vtkRelievoStage* stage)
  {
    if (this->Window)
    {
      stage->ReleaseGraphicsResources(this->Window);
    }
    this->Reader.Forget(stage);
  }
};

#endif
