// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Medians and ratios of known numbers, the order of the rounds, and the clock itself.
#include "Check.h"
#include "FrameTimer.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <thread>

namespace testFrameTimer
{
namespace
{
using relievoTest::Interleave;
using relievoTest::Timed;
using relievoTest::Timing;
using relievoTest::TimingPair;

void TestNumbers()
{
  const Timing odd{ { 5., 1., 3. } };
  RELIEVO_CHECK(odd.Median() == 3. && odd.Quantile(0.) == 1. && odd.Quantile(1.) == 5.);
  const Timing even{ { 4., 1., 2., 3. } };
  RELIEVO_CHECK(even.Median() == 2.5 && even.Quantile(0.75) == 3.25);
  RELIEVO_CHECK(std::isnan(Timing().Median()));

  // An outlier changes the mean, but not the median.
  TimingPair pair;
  pair.A.Seconds = { 2., 2., 2., 200., 2. };
  pair.B.Seconds = { 1., 1., 1., 1., 1. };
  RELIEVO_CHECK(pair.Ratio() == 2.);
  // If all rounds agree, the interval is empty; a single round decides nothing.
  pair.A.Seconds = { 2., 2., 2. };
  pair.B.Seconds = { 1., 1., 1. };
  RELIEVO_CHECK(pair.RatioSpread() == 0.);
  pair.A.Seconds = { 2. };
  pair.B.Seconds = { 1. };
  RELIEVO_CHECK(std::isinf(pair.RatioSpread()));
  pair.A.Seconds = { 1., 2., 3., 1., 2., 3., 2. };
  pair.B.Seconds = { 1., 1., 1., 1., 1., 1., 1. };
  RELIEVO_CHECK(pair.RatioSpread() > 0.1 && pair.RatioSpread() <= 1.);
  RELIEVO_CHECK(pair.ToString("x", "y").find("x 2000 ms, y 1000 ms, ratio 2 +- ") == 0);
}

void TestOrder()
{
  std::string order;
  const Timed a{ [&] { order += 'a'; }, [&] { order += 'p'; } };
  const Timed b{ [&] { order += 'b'; }, {} };
  const TimingPair pair = Interleave(a, b, 3, 2);
  RELIEVO_CHECK_THAT(order == "pabbpapabbpapab", order);
  RELIEVO_CHECK(pair.A.Seconds.size() == 3 && pair.B.Seconds.size() == 3);
}

void TestClock()
{
  const auto sleep = [](int milliseconds) {
    return [milliseconds] { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); };
  };
  // Preparation and warm-up are not timed. A sleep is never shorter than requested, even on a busy
  // machine, so neither is the time left out.
  const auto begin = std::chrono::steady_clock::now();
  const TimingPair pair =
    Interleave(Timed{ sleep(20), sleep(5) }, Timed{ sleep(5), sleep(20) }, 9, 3);
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
  std::cout << pair.ToString("20 ms", "5 ms") << "\n";
  RELIEVO_CHECK(pair.A.Quantile(0.) >= 0.02 && pair.B.Quantile(0.) >= 0.005);
  const double timed = std::accumulate(pair.A.Seconds.begin(), pair.A.Seconds.end(), 0.) +
    std::accumulate(pair.B.Seconds.begin(), pair.B.Seconds.end(), 0.);
  RELIEVO_CHECK(all.count() - timed >= 9 * 0.025 + 3 * 0.05);
}

void TestFrames()
{
  vtkNew<vtkRenderer> renderer;
  const auto window = relievoTest::MakeWindow(100, 100, renderer);
  int prepared = 0;
  const Timed frame = relievoTest::Frame(window, [&] { ++prepared; });
  const TimingPair pair = Interleave(frame, relievoTest::Frame(window), 5);
  std::cout << pair.ToString("empty frame", "the same") << "\n";
  RELIEVO_CHECK(prepared == 8 && pair.A.Median() > 0. && pair.B.Median() > 0.);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFrameTimer)
{
  relievoTest::Session session;
  TestNumbers();
  TestOrder();
  TestClock();
  TestFrames();
  return session.Result();
}
}
