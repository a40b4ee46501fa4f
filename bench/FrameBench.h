// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameBench.h
 * @brief What the benches of whole frames share: reference scenes in windows, ways timed in turn.
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
/** A reference scene in a window of its own: one way's shaders never push out another's. */
struct SceneWindow
{
  relievoTest::ReferenceScene Scene;
  vtkSmartPointer<vtkRenderWindow> Window;

  SceneWindow(vtkPolyData* mesh, int width, int height);

  /** Work that draws one frame to the end. */
  relievoTest::Timed Frame() const { return relievoTest::Frame(this->Window); }
};

/**
 * The mesh of a reference scene, placed. Null, with a message on the standard error, when the file
 * is not in the folder that the environment variable RELIEVO_DATA names.
 */
vtkSmartPointer<vtkPolyData> SceneMesh(const std::string& name);

/**
 * Runs every way `rounds` times, in turn, after `warmUp` rounds that do not count; less where
 * SetMostRounds (Rounds.h) says so. The way that begins changes from round to round, so that none
 * always follows the same other.
 */
std::vector<relievoTest::Timing> TimeInTurn(
  const std::vector<relievoTest::Timed>& ways, int rounds, int warmUp = 3);

/** Also takes the processor time of all threads, which other work on the machine hardly changes. */
std::vector<relievoTest::Timing> TimeInTurn(
  std::vector<relievoTest::Timed> ways, int rounds, std::vector<relievoTest::Timing>& processor);

/** Two of them, for Ratio() and RatioSpread(). */
relievoTest::TimingPair PairOf(const relievoTest::Timing& a, const relievoTest::Timing& b);

/** The machine's load average over a minute, for the record beside timings; NaN where not known. */
double LoadAverage();
}

#endif
