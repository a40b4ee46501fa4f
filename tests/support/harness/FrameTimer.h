// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameTimer.h
 * @brief Times two methods against each other, in turn, in one process.
 */
#ifndef relievoTestFrameTimer_h
#define relievoTestFrameTimer_h

#include <functional>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace relievoTest
{
/** Wall-clock seconds of one method. */
struct Timing
{
  std::vector<double> Seconds;

  double Median() const;
  /** The share-th quantile, 0 to 1, interpolated between neighbours. NaN without timings. */
  double Quantile(double share) const;
};

/** Two methods timed in turn. */
struct TimingPair
{
  Timing A;
  Timing B;

  /** Median of A over median of B. */
  double Ratio() const;

  /**
   * Half the width of the 95 % interval of the ratio, by resampling rounds 2000 times (bootstrap,
   * fixed seed): a nearer limit cannot be decided.
   */
  double RatioSpread() const;

  /** `A 12.3 ms, B 10.1 ms, ratio 1.22 +- 0.02 (41 rounds)`, with the names given. */
  std::string ToString(const std::string& nameOfA, const std::string& nameOfB) const;
};

/** One thing to time: `Prepare` is not timed, `Work` is. */
struct Timed
{
  std::function<void()> Work;
  std::function<void()> Prepare;
};

/**
 * Runs A and B `rounds` times each, in turn, after `warmUp` unmeasured rounds. Which of the two
 * comes first changes from round to round, so that neither always finds the other's caches.
 */
TimingPair Interleave(const Timed& a, const Timed& b, int rounds, int warmUp = 3);

/** Renders a window and waits until the graphics card has finished (glFinish). */
void RenderAndFinish(vtkRenderWindow* window);

/** Work that renders a window completely. */
Timed Frame(
  vtkRenderWindow* window, const std::function<void()>& prepare = std::function<void()>());
}

#endif
