// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowPlanner.h"

#include "vtkRelievoShadowMethods.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace
{
using Choice = vtkRelievoShadowPlanner::Choice;

// Milliseconds for one of each: on software OpenGL, fitted to the frames of `relievo bench planner`
// and of small scenes on two cores; for a common GPU, estimated, not measured.
struct Costs
{
  double Pixel;    // shaded
  double Triangle; // drawn
  double Draw;     // call
  double Texel;    // of a redrawn map
  double Lookup;   // in a map, per pixel and light
  double Piece;    // of a warped map, beyond the first, as a share of its cost
  double Trace;    // per pixel, light and level of the tree
  double Start;    // per pixel: finding the rays' starts
  double Passes;   // over the picture, before and between rays
};
constexpr Costs Software = { 6e-5, 1.3e-4, 0.02, 1.8e-6, 5e-6, 0.3, 3.5e-6, 1.2e-5, 1.5 };
constexpr Costs Hardware = { 5e-7, 1e-6, 0.01, 4e-8, 2e-7, 0.1, 5e-7, 2e-7, 0.1 };

constexpr double CachedShare = 0.1; // share of tracing while neither view nor casters move

constexpr std::size_t Remembered = 9; // frames
constexpr std::size_t Enough = 5;     // frames of a choice; with fewer, those of others are used
constexpr long long Old = 300;        // age in frames beyond which a choice's times are ignored
constexpr long long Settles = 20; // frames without motion after which the scene counts as static
constexpr double Stays = 1.1;     // factor on the time up to which a choice stays
constexpr double Enters = 0.85;   // and below which a more accurate one is chosen

std::string Percent(double share)
{
  std::ostringstream out;
  out.precision(2);
  out << 100.0 * share << " %";
  return out.str();
}

std::string Milliseconds(double time)
{
  std::ostringstream out;
  out.precision(3);
  out << time << " ms";
  return out.str();
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPlanner::Choice::GetWords() const
{
  static const char* const names[] = { "map", "forward", "warped", "exact" };
  return names[this->Method] + (this->Size > 0 ? " " + std::to_string(this->Size) : std::string());
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPlanner::Key::operator<(const Key& other) const
{
  return std::tie(this->Method, this->Size, this->Redraws) <
    std::tie(other.Method, other.Size, other.Redraws);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPlanner::Model(const Choice& choice, const SceneCost& cost, bool redraws)
{
  const Costs& costs = cost.Software ? Software : Hardware;
  const double geometry = costs.Triangle * cost.Triangles + costs.Draw * cost.Props;
  double time = geometry + costs.Pixel * cost.Pixels;
  if (choice.Method == vtkRelievoShadowMethods::EXACT)
  {
    const double trace = costs.Trace * cost.Lights * std::log2(2.0 + std::max(0.0, cost.Triangles));
    return time +
      (redraws ? 1.0 : CachedShare) * (costs.Passes + (costs.Start + trace) * cost.Pixels);
  }
  time += costs.Lookup * cost.Pixels * cost.Lights;
  const double pieces = choice.Method == vtkRelievoShadowMethods::WARPED ? 1.0 + costs.Piece : 1.0;
  const double texels = static_cast<double>(choice.Size) * choice.Size;
  return time + (redraws ? cost.Maps * (pieces * geometry + costs.Texel * texels) : 0.0);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPlanner::GetTime(
  const Choice& choice, const SceneCost& cost, bool redraws) const
{
  const auto measured = this->Ratios.find({ choice.Method, choice.Size, redraws });
  std::vector<double> own;
  if (measured != this->Ratios.end())
  {
    for (const Measured& each : measured->second)
    {
      if (each.Frame + Old > this->Frame)
      {
        own.push_back(each.Ratio);
      }
    }
  }
  const double others = GetMedian(this->AllRatios, 1.0);
  while (own.size() < Enough)
  {
    own.push_back(others);
  }
  return GetMedian(own, 1.0) * Model(choice, cost, redraws);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPlanner::GetMedian(std::vector<double> numbers, double none)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? none : numbers[numbers.size() / 2];
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPlanner::Redraws(const Choice& choice, const Invalidated& invalidated)
{
  return choice.Method == vtkRelievoShadowMethods::EXACT ? invalidated.Rays : invalidated.Maps;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanner::AddFrame(const Invalidated& invalidated)
{
  ++this->Frames;
  this->Latest = invalidated;
  this->MapsMoved = invalidated.Maps ? this->Frames : this->MapsMoved;
  this->RaysMoved = invalidated.Rays ? this->Frames : this->RaysMoved;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanner::AddTime(const Choice& choice, const SceneCost& cost,
  const Invalidated& invalidated, double milliseconds, double planning)
{
  const bool redraws = Redraws(choice, invalidated);
  const double model = Model(choice, cost, redraws);
  const double drawing = milliseconds - planning;
  if (!(model > 0.0) || !(drawing > 0.0))
  {
    return;
  }
  const auto add = [](auto& ratios, const auto& ratio) {
    ratios.push_back(ratio);
    if (ratios.size() > Remembered)
    {
      ratios.erase(ratios.begin());
    }
  };
  ++this->Frame;
  add(this->Ratios[{ choice.Method, choice.Size, redraws }],
    Measured{ drawing / model, this->Frame });
  add(this->AllRatios, drawing / model);
  add(this->Plannings, planning);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanner::Forget()
{
  *this = vtkRelievoShadowPlanner();
}

//------------------------------------------------------------------------------
vtkRelievoShadowPlanner::Plan vtkRelievoShadowPlanner::Choose(
  const Goal& goal, const std::vector<Choice>& choices, const SceneCost& cost)
{
  const auto accurate = [&goal](const Choice& choice) {
    return Margin * choice.WrongShare <= goal.Tolerance ||
      (choice.Method == vtkRelievoShadowMethods::EXACT && choice.WrongShare <= goal.Tolerance);
  };
  const auto better = [](const Choice& a, const Choice& b) { return a.WrongShare < b.WrongShare; };
  const auto cheaper = [&cost](const Choice& a, const Choice& b) {
    return Model(a, cost, true) < Model(b, cost, true);
  };
  // Compares choices by the expected frames, not by the latest alone: a camera that stops and
  // starts would otherwise change the choice each time.
  const auto moves = [this](long long last) {
    return this->Frames == 0 || (last > 0 && last + Settles > this->Frames);
  };
  const Invalidated likely{ moves(this->MapsMoved), moves(this->RaysMoved) };
  // Casters that change in most frames have most of those frames planned again.
  const double planning = GetMedian(this->Plannings, 0.0);
  const auto time = [&](const Choice& choice) {
    return planning + this->GetTime(choice, cost, Redraws(choice, likely));
  };
  Plan plan;
  std::vector<Choice> left;
  std::copy_if(choices.begin(), choices.end(), std::back_inserter(left), accurate);
  if (goal.Tolerance > 0.0 && !left.empty())
  {
    plan.Chosen = *std::min_element(left.begin(), left.end(), cheaper);
  }
  else if (goal.Time <= 0.0)
  {
    plan.Chosen = *std::min_element(choices.begin(), choices.end(), better);
    plan.Words = "the tolerance is not met";
  }
  else
  {
    // The previous choice stays while it is fast enough and no better one surely is.
    const auto current = std::find(choices.begin(), choices.end(), this->Current);
    const bool stays =
      this->HasCurrent && current != choices.end() && time(*current) <= Stays * goal.Time;
    const double limit = (this->HasCurrent ? Enters : 1.0) * goal.Time;
    left.clear();
    std::copy_if(choices.begin(), choices.end(), std::back_inserter(left),
      [&](const Choice& choice) { return time(choice) <= limit || (stays && choice == *current); });
    plan.Chosen = left.empty() ? *std::min_element(choices.begin(), choices.end(), cheaper)
                               : *std::min_element(left.begin(), left.end(), better);
    plan.Words = goal.Tolerance > 0.0 ? "the tolerance is not met" : "";
  }
  plan.Milliseconds =
    planning + this->GetTime(plan.Chosen, cost, Redraws(plan.Chosen, this->Latest));
  if (goal.Time > 0.0 && plan.Milliseconds > Stays * goal.Time)
  {
    plan.Words += std::string(plan.Words.empty() ? "" : ", ") + "the time is not met";
  }
  this->Current = plan.Chosen;
  this->HasCurrent = true;
  std::ostringstream out;
  out << plan.Chosen.GetWords() << " was chosen for ";
  if (goal.Tolerance > 0.0)
  {
    out << "a tolerance of " << Percent(goal.Tolerance) << (goal.Time > 0.0 ? " and " : "");
  }
  if (goal.Time > 0.0)
  {
    out << "a time of " << Milliseconds(goal.Time);
  }
  out << " (expected " << Percent(plan.Chosen.WrongShare) << " wrong, "
      << Milliseconds(plan.Milliseconds) << ")" << (plan.Words.empty() ? "" : ": ") << plan.Words;
  plan.Words = out.str();
  return plan;
}
