// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which objects of two frames are the same, and what has become of each: from the records where
// both frames have one, otherwise from the cells and positions that both frames show.
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
  int Finding = -1;  // in the list, of what changed
  int Settings = -1; // in the list, of a property that differs

  // What of the frame a changed object without a place in the layers may cover.
  bool IsTranslucent = false;
  std::array<double, 6> Bounds{ 1., -1., 1., -1., 1., -1. }; // of both frames
};

class ObjectChanges
{
public:
  ObjectChanges(const Frame& before, const Frame& after, const Limits& limits, CauseList& list);

  // The number of an object in the other frame; -1: it has none, or `object` is none.
  int GetAfter(int object) const { return Get(this->After, object); }
  int GetBefore(int object) const { return Get(this->Before, object); }

  // What has become of an object of the frame before, and of the one after.
  const Change& OfBefore(int object) const { return Get(this->BeforeChanges, object); }
  const Change& OfAfter(int object) const { return Get(this->AfterChanges, object); }
  const std::vector<Change>& GetBeforeChanges() const { return this->BeforeChanges; }
  const std::vector<Change>& GetAfterChanges() const { return this->AfterChanges; }

  // Whether any object has changed.
  bool AnyChanged() const;

  // The name of an object of the frame before, or of that which it is in the frame after.
  std::string GetName(int object) const;

  std::size_t GetNumber() const { return this->BeforeChanges.size(); }

  // Whether depths of a pixel, which shows the same surface in both frames, differ.
  static bool DiffersInDepth(
    const Frame& before, const Frame& after, std::size_t pixel, const Limits& limits);

private:
  // What is seen of a cell.
  struct Patch
  {
    std::array<double, 3> Sum{}, Normal{}; // of positions; not normalized
    double Pixels = 0.;
    bool IsWhole = true; // nothing nearer, and no border of the picture, cuts it
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

  // The translation that takes what both frames show of an object from one to the other, by least
  // squares over its cells: planes tell it exactly along their normals, centres of cells to about
  // a pixel. None, if no translation does.
  std::optional<std::array<double, 3>> FindTranslation(int before, int after) const;
  const Patches& GetPatches(int object, bool isBefore) const;

  const Frame& A;
  const Frame& B;
  const Limits& Bounds;
  CauseList& List;
  std::vector<int> After, Before;
  std::vector<Change> BeforeChanges, AfterChanges;
  std::vector<std::vector<std::size_t>> Seen[2]; // the pixels of each object, of A and of B
  mutable std::vector<Patches> AllPatches[2];    // by object; empty: not looked for yet
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
