// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameTimer.h"

#include <vtkRenderWindow.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace relievoTest
{
namespace
{
double QuantileOf(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const double place = std::clamp(share, 0., 1.) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double SecondsOf(const Timed& timed)
{
  if (timed.Prepare)
  {
    timed.Prepare();
  }
  const auto begin = std::chrono::steady_clock::now();
  timed.Work();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double>(end - begin).count();
}
}

//------------------------------------------------------------------------------
double Timing::Median() const
{
  return this->Quantile(0.5);
}

//------------------------------------------------------------------------------
double Timing::Quantile(double share) const
{
  return QuantileOf(this->Seconds, share);
}

//------------------------------------------------------------------------------
double TimingPair::Ratio() const
{
  return this->A.Median() / this->B.Median();
}

//------------------------------------------------------------------------------
double TimingPair::RatioSpread() const
{
  const size_t rounds = std::min(this->A.Seconds.size(), this->B.Seconds.size());
  if (rounds < 2)
  {
    return std::numeric_limits<double>::infinity();
  }
  std::mt19937 random(1);
  std::uniform_int_distribution<size_t> choose(0, rounds - 1);
  std::vector<double> ratios;
  TimingPair sample;
  for (int i = 0; i < 2000; ++i)
  {
    sample.A.Seconds.clear();
    sample.B.Seconds.clear();
    for (size_t j = 0; j < rounds; ++j)
    {
      // Keeps both timings of a round together: a slow machine slows both.
      const size_t round = choose(random);
      sample.A.Seconds.push_back(this->A.Seconds[round]);
      sample.B.Seconds.push_back(this->B.Seconds[round]);
    }
    ratios.push_back(sample.Ratio());
  }
  return 0.5 * (QuantileOf(ratios, 0.975) - QuantileOf(ratios, 0.025));
}

//------------------------------------------------------------------------------
std::string TimingPair::ToString(const std::string& nameOfA, const std::string& nameOfB) const
{
  std::ostringstream text;
  text.precision(4);
  text << nameOfA << " " << 1e3 * this->A.Median() << " ms, " << nameOfB << " "
       << 1e3 * this->B.Median() << " ms, ratio " << this->Ratio() << " +- " << this->RatioSpread()
       << " (" << this->A.Seconds.size() << " rounds)";
  return text.str();
}

//------------------------------------------------------------------------------
TimingPair Interleave(const Timed& a, const Timed& b, int rounds, int warmUp)
{
  TimingPair pair;
  for (int round = -warmUp; round < rounds; ++round)
  {
    double seconds[2];
    const int first = round & 1;
    for (const int which : { first, 1 - first })
    {
      seconds[which] = SecondsOf(which == 0 ? a : b);
    }
    if (round >= 0)
    {
      pair.A.Seconds.push_back(seconds[0]);
      pair.B.Seconds.push_back(seconds[1]);
    }
  }
  return pair;
}

//------------------------------------------------------------------------------
void RenderAndFinish(vtkRenderWindow* window)
{
  window->Render();
  window->WaitForCompletion();
}

//------------------------------------------------------------------------------
Timed Frame(vtkRenderWindow* window, const std::function<void()>& prepare)
{
  return Timed{ [window] { RenderAndFinish(window); }, prepare };
}
}
