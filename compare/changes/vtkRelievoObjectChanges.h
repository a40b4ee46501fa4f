// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Matches the objects of two frames, and finds the change of each: by the records if both frames
// have one, otherwise by the visible cells and positions.
#ifndef vtkRelievoObjectChanges_h
#define vtkRelievoObjectChanges_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoComparisonLimits.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace relievo::compare
{
struct Change
{
  bool IsSame = true;
  int Finding = -1;  // index of the change in the list
  int Settings = -1; // index of a changed vtkProperty in the list
  int Coverage = -1; // equal to Settings, if these affect which pixels the object covers
  int Color = -1;    // index of a changed colour in the list

  // The region that a changed object may cover if it appears in no layer.
  bool IsTranslucent = false;
  std::array<double, 6> Bounds{ 1., -1., 1., -1., 1., -1. }; // of both frames together
};

class ObjectChanges
{
public:
  ObjectChanges(const Frame& before, const Frame& after, const Limits& limits, CauseList& list);

  // The number of an object in the other frame; -1: no match, or `object` is -1.
  int GetAfter(int object) const { return Get(this->After, object); }
  int GetBefore(int object) const { return Get(this->Before, object); }

  // The change of an object, by its number in the frame before, or in the frame after.
  const Change& OfBefore(int object) const { return Get(this->BeforeChanges, object); }
  const Change& OfAfter(int object) const { return Get(this->AfterChanges, object); }
  const std::vector<Change>& GetBeforeChanges() const { return this->BeforeChanges; }
  const std::vector<Change>& GetAfterChanges() const { return this->AfterChanges; }

  bool AnyChanged() const;

  // The name of an object by its number in the frame before; without one, its name in the frame
  // after.
  std::string GetName(int object) const;

  std::size_t GetNumber() const { return this->BeforeChanges.size(); }

  // Whether the depths differ at a pixel that shows the same surface in both frames.
  static bool DiffersInDepth(
    const Frame& before, const Frame& after, std::size_t pixel, const Limits& limits);

private:
  // The visible part of a cell.
  struct Patch
  {
    std::array<double, 3> Sum{}, Normal{}; // sum of positions; normal, not normalized
    double Pixels = 0.;
    bool IsWhole = true; // cut neither by a nearer surface nor by the picture's border
  };
  using Patches = std::unordered_map<std::int64_t, Patch>;

  template <typename T>
  static typename std::vector<T>::const_reference Get(const std::vector<T>& all, int place)
  {
    static const std::vector<T> none = { Nothing<T>() };
    return place >= 0 && place < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(place)]
                                                              : none[0];
  }
  template <typename T>
  static T Nothing();

  void MatchByRecord();
  void MatchBySight();
  void ChangeByRecord();
  void ChangeBySight();
  void Pair(int before, int after);
  bool IsHidden(int object, bool isBefore) const;
  void AddMove(
    int object, const std::array<double, 16>& transform, const std::array<double, 3>& displacement);
  void AddChange(int before, int after, Cause cause, const std::string& words);
  void CompareSettings(int before, int after);
  void MatchByBounds();
  void MatchMoved();

  // The translation between the visible parts of an object in the two frames, by least squares over
  // its cells: exact along the normals of planes, and accurate to about a pixel from the centres of
  // cells. None if no translation fits.
  std::optional<std::array<double, 3>> FindTranslation(int before, int after) const;
  const Patches& GetPatches(int object, bool isBefore) const;

  const Frame& A;
  const Frame& B;
  const Limits& Bounds;
  CauseList& List;
  std::vector<int> After, Before;
  std::vector<Change> BeforeChanges, AfterChanges;
  std::vector<std::vector<std::size_t>> Seen[2]; // the pixels of each object, of A and of B
  mutable std::vector<Patches> AllPatches[2];    // by object; empty: not computed yet
};

template <>
inline int ObjectChanges::Nothing<int>()
{
  return -1;
}
template <>
inline Change ObjectChanges::Nothing<Change>()
{
  return {};
}
}

#endif
