// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameBench.h
 * @brief Shared by benches of whole frames: reference scenes in windows, and methods timed in turn.
 */
#ifndef relievoBenchFrameBench_h
#define relievoBenchFrameBench_h

#include "FrameTimer.h"
#include "Scenes.h"

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace relievoBench
{
/** A reference scene in its own window, so that methods do not evict each other's shaders. */
struct SceneWindow
{
  relievoTest::ReferenceScene Scene;
  vtkSmartPointer<vtkRenderWindow> Window;

  SceneWindow(vtkPolyData* mesh, int width, int height);

  /** Draws one complete frame. */
  relievoTest::Timed Frame() const { return relievoTest::Frame(this->Window); }
};

/**
 * The mesh of a reference scene, placed. Null, with a message on the standard error, if its file is
 * missing in the folder named by the environment variable RELIEVO_DATA.
 */
vtkSmartPointer<vtkPolyData> SceneMesh(const std::string& name);

/**
 * Runs every method `rounds` times, in turn, after `warmUp` unmeasured rounds; fewer if
 * SetMostRounds (Rounds.h) limits them. The first method changes from round to round, so that none
 * always follows the same other.
 */
std::vector<relievoTest::Timing> TimeInTurn(
  const std::vector<relievoTest::Timed>& ways, int rounds, int warmUp = 3);

/**
 * Also measures the processor time of all threads, which other work on the machine hardly changes.
 */
std::vector<relievoTest::Timing> TimeInTurn(
  std::vector<relievoTest::Timed> ways, int rounds, std::vector<relievoTest::Timing>& processor);

/** Combines two timings, for Ratio() and RatioSpread(). */
relievoTest::TimingPair PairOf(const relievoTest::Timing& a, const relievoTest::Timing& b);

/** The machine's load average over a minute, for the record beside timings; NaN if unknown. */
double LoadAverage();
}

#endif
