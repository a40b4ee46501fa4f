// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GPU time of named spans of a frame, from pairs of timestamps that are read a frame or more later
// and never waited for: where the ring is full, a frame goes untimed.
#ifndef vtkRelievoGpuTimer_h
#define vtkRelievoGpuTimer_h

#include "vtkWeakPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

class vtkRelievoGpuTimer
{
public:
  vtkRelievoGpuTimer() = default;
  ~vtkRelievoGpuTimer();
  vtkRelievoGpuTimer(const vtkRelievoGpuTimer&) = delete;
  void operator=(const vtkRelievoGpuTimer&) = delete;

  void BeginFrame(vtkOpenGLRenderWindow* window);
  void EndFrame();

  // Spans of one name add up; they may nest and overlap.
  void Begin(const std::string& name);
  void End(const std::string& name);

  // Of the newest frame that has arrived; negative if none has, or if it has no such span.
  double GetMilliseconds(const std::string& name) const;

  void Release();

private:
  struct Span
  {
    std::string Name;
    unsigned int Queries[2];
    bool Ended;
  };
  struct Frame
  {
    std::vector<Span> Spans;
    bool Pending = false;
  };
  static constexpr int RingSize = 4;

  bool Collect(Frame& frame);
  unsigned int TakeQuery();

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  Frame Ring[RingSize];
  std::vector<unsigned int> FreeQueries;
  Frame* Current = nullptr;
  std::map<std::string, double> Milliseconds;
};

#endif
