// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chooses the method for shadows: the cheapest one that is accurate enough, or the most accurate
// one that is fast enough.
//
// For a tolerance the choice depends only on the input. For a time it also depends on the times of
// earlier frames.
#ifndef vtkRelievoShadowPlanner_h
#define vtkRelievoShadowPlanner_h

#include <map>
#include <string>
#include <vector>

class vtkRelievoShadowPlanner
{
public:
  // A method of vtkRelievoShadowStage and the side of its maps (0: none).
  struct Choice
  {
    int Method = 0;
    int Size = 0;
    double WrongShare = 0.0; // expected

    bool operator==(const Choice& other) const
    {
      return this->Method == other.Method && this->Size == other.Size;
    }
    std::string GetWords() const;
  };

  // The scene's properties that determine a frame's time, beside the choice.
  struct SceneCost
  {
    double Pixels = 0.0;
    double Lights = 0.0;
    double Maps = 0.0;
    double Triangles = 0.0;
    double Props = 0.0;
    bool Software = false;
  };

  // Results of the previous frame that are invalid for any choice: the depths in maps, the verdicts
  // of rays.
  struct Invalidated
  {
    bool Maps = false;
    bool Rays = false;
  };

  // Goals: share of wrong pixels, 0: any; milliseconds of a frame, 0: any.
  struct Goal
  {
    double Tolerance = 0.0;
    double Time = 0.0;
  };

  // Chooses among these for a cost. `Words` explains which part of the goal is not met.
  struct Plan
  {
    Choice Chosen;
    double Milliseconds = 0.0; // expected
    std::string Words;
  };
  Plan Choose(const Goal& goal, const std::vector<Choice>& choices, const SceneCost& cost);

  // The time of a frame without planning, expected from earlier ones or from figures of common
  // machines. `redraws`: whether it draws its maps again.
  double GetTime(const Choice& choice, const SceneCost& cost, bool redraws) const;

  // Records a frame and its changes. Occasional changes are expected to continue.
  void AddFrame(const Invalidated& invalidated);

  // Records the frame's time, of which `planning` was spent on the plan, whatever the choice.
  void AddTime(const Choice& choice, const SceneCost& cost, const Invalidated& invalidated,
    double milliseconds, double planning = 0.0);

  void Forget();

  // Factor between a tolerance and an acceptable estimate, because estimates have errors.
  static constexpr double Margin = 1.2;

private:
  static double Model(const Choice& choice, const SceneCost& cost, bool redraws);
  static bool Redraws(const Choice& choice, const Invalidated& invalidated);

  // Ratios of measured to expected times, the latest last, by method, size and whether maps were
  // drawn.
  struct Key
  {
    int Method;
    int Size;
    bool Redraws;
    bool operator<(const Key& other) const;
  };
  struct Measured
  {
    double Ratio;
    long long Frame;
  };
  static double GetMedian(std::vector<double> numbers, double none);

  std::map<Key, std::vector<Measured>> Ratios;
  std::vector<double> AllRatios;    // of the latest frames with any choice
  std::vector<double> Plannings;    // of these frames, milliseconds
  long long Frame = 0;              // number of frames with a time
  Invalidated Latest{ true, true }; // before the first frame, everything is new
  long long Frames = 0;
  long long MapsMoved = 0; // the latest of these frames in which maps changed
  long long RaysMoved = 0;
  Choice Current;
  bool HasCurrent = false;
};

#endif
