// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GPU time of named spans of a frame, from pairs of timestamps that are read one or more frames
// later without waiting; if the ring is full, a frame is not timed.
//
// Software OpenGL (Mesa's llvmpipe) sorts a frame's commands into tiles and takes the timestamps
// when it draws these, not between the commands, so that timestamps cannot measure a span. There a
// span is timed by finishing the commands at both ends, which costs some of the frame's
// parallelism, and is done only while times are requested.
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

  // Spans with equal names add up; spans may nest and overlap.
  void Begin(const std::string& name);
  void End(const std::string& name);

  // Requests times for the next frames, for which software OpenGL finishes commands.
  void Want() { this->Wanted = FramesWanted; }

  // Whether times are missing because none were requested.
  bool IsUntimed() const { return this->Defers && this->Milliseconds.empty(); }

  // Time in the newest frame that has arrived; negative without one, or without such a span.
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
    long long Number = 0;
    bool Pending = false;
  };
  static constexpr int RingSize = 4;
  static constexpr int FramesWanted = 8;

  bool Collect(Frame& frame);
  unsigned int TakeQuery();

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  Frame Ring[RingSize];
  std::vector<unsigned int> FreeQueries;
  Frame* Current = nullptr;
  long long Number = 0;  // of frames so far
  long long Arrived = 0; // the frame of Milliseconds
  std::map<std::string, double> Milliseconds;

  int Wanted = 0;        // frames still to be timed
  bool Defers = false;   // timestamps cannot measure a span
  bool Finishes = false; // finish this frame's commands at the ends of spans
  // Milliseconds of this frame's spans; minus the start while open.
  std::map<std::string, double> Finished;
};

#endif
