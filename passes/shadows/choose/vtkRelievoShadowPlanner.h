// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chooses how shadows are made: the cheapest choice that is accurate enough, or the most accurate
// one that is fast enough.
//
// For a tolerance the choice follows from what it is given alone. For a time it follows from the
// times of earlier frames as well.
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

  // What of the scene a frame's time depends on, beside the choice.
  struct SceneCost
  {
    double Pixels = 0.0;
    double Lights = 0.0;
    double Maps = 0.0;
    double Triangles = 0.0;
    double Props = 0.0;
    bool Software = false;
  };

  // What of the frame before cannot be kept, whatever the choice: the depths in maps, the verdicts
  // of rays.
  struct Invalidated
  {
    bool Maps = false;
    bool Rays = false;
  };

  // Shares of wrong pixels, 0: any; milliseconds of a frame, 0: any.
  struct Goal
  {
    double Tolerance = 0.0;
    double Time = 0.0;
  };

  // Of choices, all for the same cost. `Words` says what of the goal is not met.
  struct Plan
  {
    Choice Chosen;
    double Milliseconds = 0.0; // expected
    std::string Words;
  };
  Plan Choose(const Goal& goal, const std::vector<Choice>& choices, const SceneCost& cost);

  // The time of a frame, without that of planning: expected from earlier ones, or from figures of
  // common machines. `redraws`: it draws its maps again.
  double GetTime(const Choice& choice, const SceneCost& cost, bool redraws) const;

  // A frame was drawn in which this moved. What moves now and then is expected to go on.
  void AddFrame(const Invalidated& invalidated);

  // It took so long; of that, `planning` to plan, which it would have taken with every choice.
  void AddTime(const Choice& choice, const SceneCost& cost, const Invalidated& invalidated,
    double milliseconds, double planning = 0.0);

  void Forget();

  // Estimates are this many times better than a tolerance, as their own error needs it.
  static constexpr double Margin = 1.2;

private:
  static double Model(const Choice& choice, const SceneCost& cost, bool redraws);
  static bool Redraws(const Choice& choice, const Invalidated& invalidated);

  // Measured times over the model's, the latest last, by method, size and whether maps were drawn.
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
  std::vector<double> AllRatios;    // of the latest frames, whatever their choice
  std::vector<double> Plannings;    // of these frames, milliseconds
  long long Frame = 0;              // of those with a time
  Invalidated Latest{ true, true }; // before there is a frame, everything is new
  long long Frames = 0;
  long long MapsMoved = 0; // the latest of these frames in which they did
  long long RaysMoved = 0;
  Choice Current;
  bool HasCurrent = false;
};

#endif
