// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the frame did and why, as JSON.
#ifndef vtkRelievoFrameReport_h
#define vtkRelievoFrameReport_h

#include <string>
#include <vector>

class vtkRelievoGpuTimer;

struct vtkRelievoFrameReport
{
  struct Line
  {
    std::string Name;
    bool Ran = false;
    std::string Reason;
    long long Bytes = 0;
    int DrawCalls = -1; // -1: not counted
  };
  std::vector<Line> Lines;
  int Size[2] = { 0, 0 };
  std::string PrimitiveIds; // how the numbers of primitives come about; empty: not needed

  std::string GetJSON(const vtkRelievoGpuTimer& timer) const;
};

#endif
