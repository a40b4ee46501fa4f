// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the opaque surfaces of a sample in horizontal strips, one after the other, so that the
// program can abort the sample in between (AbortCheckEvent). The sample's pixels are the same.
//
// Each strip transforms all meshes again. A thin first strip measures the time of that, and meshes
// for which it is long are drawn in one go.
#ifndef vtkRelievoSampleStrips_h
#define vtkRelievoSampleStrips_h

#include <chrono>

class vtkRelievoFrameContext;

class vtkRelievoSampleStrips
{
public:
  ///@{
  // Limits the delegate's drawing to the first strip. End() draws the others.
  void Begin(const vtkRelievoFrameContext& context);
  void End(const vtkRelievoFrameContext& context);
  ///@}

private:
  void Limit(const vtkRelievoFrameContext& context, int rows);
  double Wait(const vtkRelievoFrameContext& context);

  std::chrono::steady_clock::time_point Begun;
  int First = 0; // row of the strip in the viewport
  int Rows = 0;
};

#endif
