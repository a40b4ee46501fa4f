// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GPU time of named spans of a frame, from pairs of timestamps that are read a frame or more later
// and never waited for: where the ring is full, a frame goes untimed.
//
// OpenGL in software (Mesa's llvmpipe) sorts a frame's commands into tiles and takes the timestamps
// when it draws these, not between the commands: such times tell nothing of a span. There a span is
// timed by finishing the commands at both its ends, which costs the frame some of its overlap, and
// so only in frames that somebody wants times of.
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

  // Somebody reads the times: the next frames' are worth waiting for where timestamps tell nothing.
  void Want() { this->Wanted = FramesWanted; }

  // There are no times because nobody has wanted any.
  bool IsUntimed() const { return this->Defers && this->Milliseconds.empty(); }

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
  long long Arrived = 0; // the frame that Milliseconds are of
  std::map<std::string, double> Milliseconds;

  int Wanted = 0;                         // frames that are
  bool Defers = false;                    // timestamps tell nothing of a span
  bool Finishes = false;                  // this frame's commands, at the ends of spans
  std::map<std::string, double> Finished; // milliseconds of this frame's spans, or less their start
};

#endif
