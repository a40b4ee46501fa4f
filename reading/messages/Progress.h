// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Progress of long work on the standard error stream. On a terminal, one line is rewritten in place
 * from the start and cleared at the end. Elsewhere (a log, a pipe), steps shorter than two seconds
 * are not reported; after that a line appears at most every five seconds. A program with a window
 * listens instead.
 */
#ifndef Progress_h
#define Progress_h

#include "ReadingNames.h"

#include <chrono>
#include <string>

class vtkObject;

namespace reading
{
/// A listener that replaces the standard error stream, and may stop the work.
class ProgressListener
{
public:
  virtual ~ProgressListener() = default;
  virtual void Say(const std::string& what, double share) = 0;
  virtual bool IsStopped() = 0;
};

class Progress
{
public:
  explicit Progress(ProgressListener* listener = nullptr);
  ~Progress();
  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /// Begins a step: `what` such as "reading bunny.off". Throws WorkError if the work was stopped.
  void Begin(const std::string& what);

  /// Reports the step's progress, 0 to 1.
  void Update(double share);

  /// Whether the listener has stopped the work.
  bool IsStopped();

  /// Ends the step; also called by Begin and the destructor.
  void End();

  /// Listens to the progress events of a VTK algorithm, which must not outlive this object.
  /// Stopping the work aborts it.
  void Observe(vtkObject* algorithm);

private:
  using Clock = std::chrono::steady_clock;

  ProgressListener* Listener;
  bool OnTerminal;
  bool Shown = false;
  std::string What;
  Clock::time_point Began, LastShown;
};
}

#endif
