// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Report on a frame and the reasons for its steps, as JSON.
#ifndef vtkRelievoFrameReport_h
#define vtkRelievoFrameReport_h

#include "vtkVariant.h"

#include <map>
#include <string>
#include <vector>

class vtkRelievoGpuTimer;
class vtkRelievoStage;
class vtkRenderer;

class vtkRelievoFrameReport
{
public:
  // Starts a report; `bytes` are the frame's own, without the stages'.
  void Begin(vtkRenderer* renderer, long long bytes);
  void Add(const std::string& name, bool ran, const std::string& code, const std::string& reason);
  void Add(vtkRelievoStage* stage, bool ran);

  std::string GetJSON(const vtkRelievoGpuTimer& timer) const;

private:
  struct Line
  {
    std::string Name;
    std::string Label; // the name for users
    bool Ran = false;
    std::string Code;
    std::string Reason;
    long long Bytes = 0;
    int DrawCalls = -1; // -1: not counted
  };
  std::vector<Line> Lines;
  std::map<std::string, vtkVariant> Facts; // of stages, by name
  long long Bytes = 0;
  int Size[2] = { 0, 0 };
};

#endif
