// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boxes on a grid, 16 bytes each, that are sorted in place while a tree is built: their ranges are
// split by the surface area heuristic.
//
// The left part of each split has a multiple of the number of boxes in a leaf: all leaves but the
// last are full.
#ifndef vtkRelievoBoxRecords_h
#define vtkRelievoBoxRecords_h

#include "vtkRelievoBoxTree.h"
#include "vtkRelievoEight.h"

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <vector>

class vtkRelievoBoxRecords
{
public:
  using Box = vtkRelievoBoxTree::Box;
  // The box of an index; called by several threads.
  using Source = std::function<Box(int)>;

  // The grid of a range's boxes: the middle has the coordinates 0.
  struct Grid
  {
    glm::vec3 Middle{ 0.f };
    float Steps; // per unit
  };
  struct Range
  {
    int First = 0;
    int Count = 0;
    vtkRelievoEight Bounds;     // as a record's
    vtkRelievoEight LowMiddle;  // of the boxes' middles, doubled
    vtkRelievoEight HighMiddle; // of the boxes' middles, doubled
  };

  // The boxes are between -1 and 1, or reach slightly beyond.
  vtkRelievoBoxRecords(int count, Source source, int leafSize);

  // All boxes, and their grid.
  Range GetAll() const { return this->MakeRange(0, this->Count); }
  static Grid GetFirstGrid();

  // Puts a range that is small on its grid on a finer one. Threads may do so with different ranges.
  void Refine(Range& range, Grid& grid);

  // Divides a range of more boxes than a leaf has. Threads may divide different ranges.
  void Split(const Range& range, Range& left, Range& right);

  // The area of a range's box, in units of its grid.
  static float GetArea(const Range& range);

  // The index of the box at a position.
  int GetIndex(int position) const { return this->All.get()[position].Index; }
  Box GetBox(int position) const { return this->From(this->GetIndex(position)); }

  // All indices. No records are left.
  std::vector<int> TakeIndices();

private:
  struct alignas(16) Record
  {
    std::int16_t Sides[6]; // least x, y, z, and greatest, negated
    int Index;
  };
  struct Cut
  {
    int Axis = -1;
    int Bin = 0;
    int Left = 0;
    float Cost;
  };
  static vtkRelievoEight GetSides(const Record& record);
  static int GetMiddle(const Record& record, int axis); // doubled
  Record MakeRecord(int index, const Grid& grid) const;
  Range MakeRange(int first, int count) const;
  int SplitFew(const Range& range);
  int SplitByBins(const Range& range);
  void Move(int first, int from, int to, int end, int axis);

  Source From;
  int Count;
  int LeafSize;
  std::unique_ptr<Record, decltype(&std::free)> All;
};

#endif
