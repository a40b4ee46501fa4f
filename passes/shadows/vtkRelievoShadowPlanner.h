// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chooses how shadows are made: the cheapest way that is accurate enough, or the most accurate one
// that is fast enough.
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
  // A method of vtkRelievoShadowPass and the side of its maps (0: none).
  struct Way
  {
    int Method = 0;
    int Size = 0;
    double WrongShare = 0.0; // expected

    bool operator==(const Way& other) const
    {
      return this->Method == other.Method && this->Size == other.Size;
    }
    std::string GetWords() const;
  };

  // What a frame's time depends on beside the way.
  struct Load
  {
    double Pixels = 0.0;
    double Lights = 0.0;
    double Maps = 0.0;
    double Triangles = 0.0;
    double Props = 0.0;
    bool Software = false;
  };

  // Shares of wrong pixels, 0: any; milliseconds of a frame, 0: any.
  struct Wish
  {
    double Tolerance = 0.0;
    double Time = 0.0;
  };

  // Of ways, all for the same load. `Words` says what of the wish is not met.
  struct Plan
  {
    Way Chosen;
    double Milliseconds = 0.0; // expected
    std::string Words;
  };
  Plan Choose(const Wish& wish, const std::vector<Way>& ways, const Load& load);

  // The time of a frame: expected from earlier ones, or from figures of common machines. `redraws`:
  // it draws its maps anew.
  double GetTime(const Way& way, const Load& load, bool redraws) const;

  // A frame took so long.
  void AddTime(const Way& way, const Load& load, bool redraws, double milliseconds);

  void Forget();

  // Estimates are this many times better than a tolerance, as their own error needs it.
  static constexpr double Margin = 1.2;

private:
  static double Model(const Way& way, const Load& load, bool redraws);

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
  static double GetMedian(std::vector<double> ratios);

  std::map<Key, std::vector<Measured>> Ratios;
  std::vector<double> AllRatios; // of the latest frames, whatever their way
  long long Frame = 0;
  bool Redraws = true; // in the latest frame
  Way Current;
  bool HasCurrent = false;
};

#endif
