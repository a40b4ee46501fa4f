// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's choices alone, on machines that are made up: for a tolerance the cheapest way that
// meets it, whatever frames took; for a time the most accurate way that fits, which stays where
// times wobble, where the camera stops and goes, and where a way takes longer than expected.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoShadowPlanner.h"

#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowChoices
{
namespace
{
using Planner = vtkRelievoShadowPlanner;
using Way = Planner::Choice;
using Anew = Planner::Invalidated;
using Pass = vtkRelievoShadowStage;

Planner::SceneCost MakeLoad()
{
  Planner::SceneCost load;
  load.Pixels = 1200000.;
  load.Lights = 1.;
  load.Maps = 1.;
  load.Triangles = 50000.;
  load.Props = 10.;
  load.Software = true;
  return load;
}

std::vector<Way> MakeWays()
{
  std::vector<Way> ways;
  for (int level = 0; level < 4; ++level)
  {
    ways.push_back({ Pass::METHOD_MAP, 1024 << level, 1e-3 / (1 << level) });
  }
  ways.push_back({ Pass::METHOD_EXACT, 0, 1e-5 });
  return ways;
}

// Frame times in milliseconds, and how far a measured one is from them: a share each way, and now
// and then three times as long.
struct Machine
{
  double Speed = 1.;       // times all
  double ExactFactor = 1.; // exact, beside that
  double Wobble = 0.;
  std::uint64_t Lots = 1;

  double Time(const Way& way, bool redraws) const
  {
    const double plain = 40.;
    const double map = 3. + 2e-6 * way.Size * way.Size * (redraws ? 1. : 0.);
    const double rays = (redraws ? 100. : 9.) * this->ExactFactor;
    return this->Speed * (plain + (way.Method == Pass::METHOD_EXACT ? rays : map));
  }

  double Measure(const Way& way, bool redraws)
  {
    this->Lots = this->Lots * 6364136223846793005ull + 1442695040888963407ull;
    const double lot = static_cast<double>(this->Lots >> 11) / 9007199254740992.;
    const double outlier = this->Wobble > 0. && (this->Lots >> 40) % 13 == 0 ? 3. : 1.;
    return this->Time(way, redraws) * outlier * (1. + this->Wobble * (2. * lot - 1.));
  }
};

// The data that a choice recomputes when the frame changes.
using Motion = std::function<Anew(int frame, const Way& way)>;

Anew Still(int, const Way&)
{
  return {};
}
Anew LightMoves(int, const Way&)
{
  return { true, true };
}

// Draws frames as the pass does, which plans anew for so many milliseconds in each. Returns the way
// of each.
std::vector<Way> Draw(Planner& planner, Machine& machine, double budget, int frames,
  const Motion& motion, double planning = 0.)
{
  std::vector<Way> drawn;
  for (int frame = 0; frame < frames; ++frame)
  {
    const Way way = planner.Choose({ 0., budget }, MakeWays(), MakeLoad()).Chosen;
    const Anew anew = motion(frame, way);
    const bool exact = way.Method == Pass::METHOD_EXACT;
    const bool fresh = drawn.empty() || !(way == drawn.back());
    if (!fresh) // another choice's frame builds its own data: the pass adds none
    {
      planner.AddFrame(anew);
      const double drawing = machine.Measure(way, exact ? anew.Rays : anew.Maps);
      planner.AddTime(way, MakeLoad(), anew, drawing + planning, planning);
    }
    drawn.push_back(way);
  }
  return drawn;
}

int CountChanges(const std::vector<Way>& drawn, std::size_t from)
{
  int changes = 0;
  for (std::size_t i = std::max<std::size_t>(1, from); i < drawn.size(); ++i)
  {
    changes += drawn[i] == drawn[i - 1] ? 0 : 1;
  }
  return changes;
}

void TestTolerance()
{
  const auto choose = [](Planner& planner, double tolerance) {
    return planner.Choose({ tolerance, 0. }, MakeWays(), MakeLoad());
  };
  const struct
  {
    double Tolerance;
    int Method;
    int Size;
  } cases[] = { { 1.3e-3, Pass::METHOD_MAP, 1024 }, { 1.1e-3, Pass::METHOD_MAP, 2048 },
    { 3.1e-4, Pass::METHOD_MAP, 4096 }, { 1.4e-4, Pass::METHOD_EXACT, 0 },
    { 1.01e-5, Pass::METHOD_EXACT, 0 }, { 1e-6, Pass::METHOD_EXACT, 0 } };
  for (const bool slow : { false, true })
  {
    for (const auto& one : cases)
    {
      Planner planner;
      for (int i = 0; i < 50 && slow; ++i) // of all the most expensive, and the cheapest in vain
      {
        planner.AddFrame({ i % 2 == 0, true });
        planner.AddTime(MakeWays()[0], MakeLoad(), { true, true }, 1e5);
        planner.AddTime(MakeWays()[4], MakeLoad(), { true, true }, 1e-2);
      }
      const Planner::Plan plan = choose(planner, one.Tolerance);
      RELIEVO_CHECK_THAT(
        plan.Chosen.Method == one.Method && plan.Chosen.Size == one.Size, plan.Words);
      RELIEVO_CHECK_THAT(
        (plan.Words.find("not met") != std::string::npos) == (one.Tolerance < 1e-5), plan.Words);
    }
  }
}

// A way that stays is at most a little over the time, and no much better one would have fitted.
void CheckChoice(const Way& chosen, const Machine& machine, double budget, bool redraws)
{
  const std::vector<Way> ways = MakeWays();
  const std::string what = chosen.GetWords() + " for " + std::to_string(budget) + " ms";
  const double time = machine.Time(chosen, redraws);
  RELIEVO_CHECK_THAT(time <= 1.25 * budget || chosen == ways[0], what + ": too slow");
  for (const Way& way : ways)
  {
    RELIEVO_CHECK_THAT(
      way.WrongShare >= chosen.WrongShare || machine.Time(way, redraws) > 0.65 * budget,
      what + ": " + way.GetWords() + " would have fitted");
  }
}

void TestWobble()
{
  int most = 0;
  for (const double speed : { 0.3, 1., 4. })
  {
    for (const double wobble : { 0., 0.1, 0.25 })
    {
      for (const bool moves : { false, true })
      {
        for (double budget = 10. * speed; budget < 200. * speed; budget *= 1.07)
        {
          Planner planner;
          Machine machine;
          machine.Speed = speed;
          machine.Wobble = wobble;
          const Motion motion = moves ? LightMoves : Still;
          const auto drawn = Draw(planner, machine, budget, 250, motion);
          const int changes = CountChanges(drawn, 40);
          most = std::max(most, changes);
          // Ways are tried a few times before their time is known.
          RELIEVO_CHECK_THAT(changes <= (wobble > 0.2     ? 4
                                            : wobble > 0. ? 2
                                                          : 0),
            std::to_string(changes) + " changes in 210 frames, " + std::to_string(budget) +
              " ms, speed " + std::to_string(speed) + ", wobble " + std::to_string(wobble));
          CheckChoice(drawn.back(), machine, budget, moves);
        }
      }
    }
  }
  std::cout << "wobble: at most " << most << " changes in 210 frames\n";
}

// A camera that moves on, or in every other frame, before casters that stay: maps are kept for most
// frames, and verdicts of rays are not.
void TestMovingCamera()
{
  struct
  {
    const char* Name;
    int Period; // of the camera's stops
    int Redraw; // of maps
  } const cases[] = { { "goes on", 0, 10 }, { "goes on, every map kept", 0, 1 << 30 },
    { "every other frame", 2, 6 }, { "in bursts", 16, 8 } };
  for (const auto& one : cases)
  {
    const Motion motion = [&one](int frame, const Way& way) {
      const bool moves = one.Period == 0 || frame % one.Period < (one.Period + 1) / 2;
      const bool exact = way.Method == Pass::METHOD_EXACT;
      return Anew{ !exact && frame % one.Redraw == one.Redraw - 1, moves };
    };
    for (const double budget : { 45., 55., 70., 100., 130., 190. })
    {
      Planner planner;
      Machine machine;
      machine.Wobble = 0.1;
      const auto drawn = Draw(planner, machine, budget, 300, motion);
      const int changes = CountChanges(drawn, 60);
      RELIEVO_CHECK_THAT(changes <= 2,
        std::string("camera ") + one.Name + ", " + std::to_string(budget) +
          " ms: " + std::to_string(changes) + " changes in 240 frames");
    }
  }
  // When it has stopped, cached data is used.
  Planner planner;
  Machine machine;
  const auto drawn = Draw(planner, machine, 70., 200, [](int frame, const Way&) {
    return Anew{ false, frame < 100 };
  });
  RELIEVO_CHECK(drawn[99].Method == Pass::METHOD_MAP);
  RELIEVO_CHECK(drawn[199].Method == Pass::METHOD_EXACT);
}

// Points that move in each frame have each planned anew: the planning time is part of the frame's,
// for any choice, and no part of the choice's own time.
void TestPlanning()
{
  for (const double planning : { 5., 40. })
  {
    for (double drawing = 20.; drawing < 300.; drawing *= 1.1)
    {
      Planner planner;
      Machine machine;
      machine.ExactFactor = 0.5; // unlike the model's expectation
      const double budget = drawing + planning;
      const auto drawn = Draw(planner, machine, budget, 100, LightMoves, planning);
      const int changes = CountChanges(drawn, 60);
      RELIEVO_CHECK_THAT(changes == 0, std::to_string(budget) + " ms: changes");
      const double time = machine.Time(drawn.back(), true) + planning;
      RELIEVO_CHECK_THAT(time <= 1.1 * budget || drawn.back() == MakeWays()[0],
        drawn.back().GetWords() + " for " + std::to_string(budget) + " ms: too slow");
      RELIEVO_CHECK_NEAR(planner.GetTime(drawn.back(), MakeLoad(), true) + planning, time,
        1e-6 * time, "what a way takes");
      const Planner::Plan plan = planner.Choose({ 0., budget }, MakeWays(), MakeLoad());
      RELIEVO_CHECK_NEAR(plan.Milliseconds, time, 1e-6 * time, "what is expected");
      // The most accurate way where it surely fits, as long as the model lets it be tried.
      RELIEVO_CHECK(drawn.back().Method == Pass::METHOD_EXACT ||
        machine.Time(MakeWays()[4], true) + planning > 0.5 * budget);
    }
  }
  // Casters that stay again cost no planning again.
  Planner planner;
  Machine machine;
  Draw(planner, machine, 100., 50, LightMoves, 80.);
  RELIEVO_CHECK(Draw(planner, machine, 175., 50, LightMoves).back().Method == Pass::METHOD_EXACT);
}

// Exact shadows that take twice the model's time are tried, left, and not soon tried again.
void TestSlowerThanExpected()
{
  for (double budget = 20.; budget < 400.; budget *= 1.1)
  {
    Planner planner;
    Machine machine;
    machine.ExactFactor = 2.;
    machine.Wobble = 0.1;
    const auto drawn = Draw(planner, machine, budget, 300, LightMoves);
    const int changes = CountChanges(drawn, 40);
    RELIEVO_CHECK_THAT(changes <= 2,
      std::to_string(budget) + " ms: " + std::to_string(changes) + " changes in 260 frames");
    CheckChoice(drawn.back(), machine, budget, true);
  }
}

// After ten frames of a way its time is known, on any machine.
void TestEstimates()
{
  for (const double speed : { 0.05, 1., 20. })
  {
    for (const Way& way : MakeWays())
    {
      for (const bool redraws : { false, true })
      {
        Planner planner;
        Machine machine;
        machine.Speed = speed;
        machine.ExactFactor = 1.5;
        machine.Wobble = 0.2;
        for (int frame = 0; frame < 10; ++frame)
        {
          const Anew anew{ redraws, redraws };
          planner.AddFrame(anew);
          planner.AddTime(way, MakeLoad(), anew, machine.Measure(way, redraws));
        }
        RELIEVO_CHECK_NEAR(planner.GetTime(way, MakeLoad(), redraws) / machine.Time(way, redraws),
          1., 0.3, way.GetWords() + ": estimate over time");
        // Half the pixels, half the time or a little more.
        Planner::SceneCost half = MakeLoad();
        half.Pixels /= 2.;
        RELIEVO_CHECK(
          planner.GetTime(way, half, redraws) < planner.GetTime(way, MakeLoad(), redraws));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowChoices)
{
  relievoTest::Session session;
  TestTolerance();
  TestWobble();
  TestMovingCamera();
  TestPlanning();
  TestSlowerThanExpected();
  TestEstimates();
  return session.Result();
}
}
