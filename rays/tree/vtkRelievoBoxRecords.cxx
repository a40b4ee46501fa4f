// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoxRecords.h"

#include "vtkRelievoAvx2.h" // for RELIEVO_INLINED
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace
{
constexpr int GridHalf = 16383;  // coordinates on a grid are at most so far from 0
constexpr int SmallRange = 1024; // on a grid: sizes of ranges that a finer grid pays for
constexpr int GridBins = 16;
constexpr int FewRecords = 32; // up to this number of boxes all splits are tried, without bins
constexpr float NoCost = std::numeric_limits<float>::max();

using Eight = vtkRelievoEight;

Eight NoBounds()
{
  return Eight::Of(std::numeric_limits<std::int16_t>::max());
}

int FillLeaves(int count, int leafSize)
{
  return (count + leafSize - 1) / leafSize * leafSize;
}

glm::ivec3 GetSizes(Eight bounds)
{
  alignas(16) std::int16_t sides[8];
  bounds.Store(sides);
  return { std::max(-sides[3] - sides[0], 0), std::max(-sides[4] - sides[1], 0),
    std::max(-sides[5] - sides[2], 0) };
}

float GetAreaOf(Eight bounds)
{
  const glm::vec3 size(GetSizes(bounds));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The largest whole number up to a value within the grid.
int RoundDown(float value)
{
  return static_cast<int>(value + static_cast<float>(2 * GridHalf)) - 2 * GridHalf;
}
}

//------------------------------------------------------------------------------
RELIEVO_INLINED vtkRelievoEight vtkRelievoBoxRecords::GetSides(const Record& record)
{
  return Eight::Load(&record); // and the index, which is not used
}

//------------------------------------------------------------------------------
RELIEVO_INLINED int vtkRelievoBoxRecords::GetMiddle(const Record& record, int axis)
{
  return record.Sides[axis] - record.Sides[axis + 3];
}

//------------------------------------------------------------------------------
vtkRelievoBoxRecords::Record vtkRelievoBoxRecords::MakeRecord(int index, const Grid& grid) const
{
  const Box box = this->From(index);
  Record record;
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr auto Far = static_cast<float>(GridHalf);
    const float low = (box.Min[axis] - grid.Middle[axis]) * grid.Steps;
    const float high = (box.Max[axis] - grid.Middle[axis]) * grid.Steps;
    record.Sides[axis] = static_cast<std::int16_t>(RoundDown(std::min(std::max(low, -Far), Far)));
    record.Sides[axis + 3] =
      static_cast<std::int16_t>(RoundDown(std::min(std::max(-high, -Far), Far)));
  }
  record.Index = index;
  return record;
}

//------------------------------------------------------------------------------
vtkRelievoBoxRecords::vtkRelievoBoxRecords(int count, Source source, int leafSize)
  : From(std::move(source))
  , Count(count)
  , LeafSize(leafSize)
  , All(static_cast<Record*>(std::malloc(sizeof(Record) * static_cast<std::size_t>(count) + 1)),
      &std::free)
{
  if (!this->All)
  {
    throw std::bad_alloc();
  }
  Record* const records = this->All.get();
  const Grid grid = GetFirstGrid();
  vtkRelievoForAll(count,
    [&](vtkIdType i) { new (records + i) Record(this->MakeRecord(static_cast<int>(i), grid)); });
}

//------------------------------------------------------------------------------
vtkRelievoBoxRecords::Grid vtkRelievoBoxRecords::GetFirstGrid()
{
  return { glm::vec3(0.f), static_cast<float>(GridHalf) };
}

//------------------------------------------------------------------------------
vtkRelievoBoxRecords::Range vtkRelievoBoxRecords::MakeRange(int first, int count) const
{
  Range range{ first, count, NoBounds(), NoBounds(), Eight::Of(-GridHalf - GridHalf - 2) };
  for (const Record* record = this->All.get() + first; count > 0; --count, ++record)
  {
    const Eight sides = GetSides(*record);
    const Eight middle = sides - sides.FromFourth();
    range.Bounds = vtkRelievoMin(range.Bounds, sides);
    range.LowMiddle = vtkRelievoMin(range.LowMiddle, middle);
    range.HighMiddle = vtkRelievoMax(range.HighMiddle, middle);
  }
  return range;
}

//------------------------------------------------------------------------------
float vtkRelievoBoxRecords::GetArea(const Range& range)
{
  return GetAreaOf(range.Bounds);
}

//------------------------------------------------------------------------------
void vtkRelievoBoxRecords::Refine(Range& range, Grid& grid)
{
  const glm::ivec3 sizes = GetSizes(range.Bounds);
  if (range.Count <= 2 * this->LeafSize || std::max({ sizes.x, sizes.y, sizes.z }) >= SmallRange)
  {
    return;
  }
  const Box nothing = { glm::vec3(NoCost), glm::vec3(-NoCost) };
  Box whole = nothing;
  const int end = range.First + range.Count;
  for (int i = range.First; i < end; ++i)
  {
    const Box box = this->GetBox(i);
    whole.Min = glm::min(whole.Min, box.Min);
    whole.Max = glm::max(whole.Max, box.Max);
  }
  const glm::vec3 half = 0.5f * whole.Max - 0.5f * whole.Min;
  const float reach = std::max({ half.x, half.y, half.z });
  if (!(reach > 1e-30f)) // a point, or nothing
  {
    return;
  }
  grid = { 0.5f * whole.Min + 0.5f * whole.Max, static_cast<float>(GridHalf) / reach };
  for (int i = range.First; i < end; ++i)
  {
    this->All.get()[i] = this->MakeRecord(this->GetIndex(i), grid);
  }
  range = this->MakeRange(range.First, range.Count);
}

//------------------------------------------------------------------------------
void vtkRelievoBoxRecords::Split(const Range& range, Range& left, Range& right)
{
  const int first = range.First;
  const int count = range.Count;
  const int inLeft = count <= FewRecords ? this->SplitFew(range) : this->SplitByBins(range);
  left = this->MakeRange(first, inLeft);
  right = this->MakeRange(first + inLeft, count - inLeft);
}

//------------------------------------------------------------------------------
// Tries every split between leaves. Returns the number of boxes in the left part.
int vtkRelievoBoxRecords::SplitFew(const Range& range)
{
  const int count = range.Count;
  Record* const records = this->All.get() + range.First;
  Record sorted[3][FewRecords];
  int best = 0;
  int left = this->LeafSize;
  float least = NoCost;
  for (int axis = 0; axis < 3; ++axis)
  {
    int keys[FewRecords];
    for (int i = 0; i < count; ++i)
    {
      keys[i] = GetMiddle(records[i], axis) * FewRecords + i;
    }
    for (int i = 0; i < count; ++i)
    {
      int rank = 0;
      for (int k = 0; k < count; ++k)
      {
        rank += keys[k] < keys[i] ? 1 : 0;
      }
      sorted[axis][rank] = records[i];
    }
    float after[FewRecords];
    Eight bounds = NoBounds();
    for (int i = count - 1; i > 0; --i)
    {
      bounds = vtkRelievoMin(bounds, GetSides(sorted[axis][i]));
      if (i % this->LeafSize == 0)
      {
        after[i] = GetAreaOf(bounds);
      }
    }
    bounds = NoBounds();
    for (int i = 1; i < count; ++i)
    {
      bounds = vtkRelievoMin(bounds, GetSides(sorted[axis][i - 1]));
      if (i % this->LeafSize == 0)
      {
        const float cost =
          GetAreaOf(bounds) * static_cast<float>(i) + after[i] * static_cast<float>(count - i);
        if (cost < least)
        {
          best = axis;
          left = i;
          least = cost;
        }
      }
    }
  }
  std::copy_n(sorted[best], count, records);
  return left;
}

//------------------------------------------------------------------------------
// Splits between a few bins, moved so that leaves are full. Returns the number of boxes in the left
// part.
int vtkRelievoBoxRecords::SplitByBins(const Range& range)
{
  const int count = range.Count;
  const int end = range.First + count;
  Record* const records = this->All.get();
  // A bin is the upper half of a product: of the distance from the lowest middle, which is first
  // enlarged if it is small.
  alignas(16) std::int16_t lows[8];
  alignas(16) std::int16_t highs[8];
  alignas(16) std::int16_t enlarge[8] = {};
  alignas(16) std::int16_t factors[8] = {};
  range.LowMiddle.Store(lows);
  range.HighMiddle.Store(highs);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int width = highs[axis] - lows[axis];
    const int times = width < 2048 ? 16 : 1;
    enlarge[axis] = static_cast<std::int16_t>(times);
    factors[axis] = static_cast<std::int16_t>(
      static_cast<std::uint16_t>(std::min(GridBins * 65536 / (times * width + 1), 65535)));
  }
  const Eight enlarges = Eight::Load(enlarge);
  const Eight multiplies = Eight::Load(factors);
  alignas(16) std::int16_t bins[3][GridBins][8];
  int counts[3][GridBins] = {};
  for (auto& axis : bins)
  {
    for (auto& bin : axis)
    {
      NoBounds().Store(bin);
    }
  }
  for (int i = range.First; i < end; ++i)
  {
    const Eight sides = GetSides(records[i]);
    const Eight distances = sides - sides.FromFourth() - range.LowMiddle;
    alignas(16) std::int16_t places[8];
    vtkRelievoMultiplyHigh(vtkRelievoMultiplyLow(distances, enlarges), multiplies).Store(places);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int bin = places[axis];
      vtkRelievoMin(Eight::Load(bins[axis][bin]), sides).Store(bins[axis][bin]);
      ++counts[axis][bin];
    }
  }
  Cut best;
  best.Cost = NoCost;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (highs[axis] == lows[axis])
    {
      continue;
    }
    float after[GridBins];
    Eight bounds = NoBounds();
    for (int bin = GridBins - 1; bin > 0; --bin)
    {
      bounds = vtkRelievoMin(bounds, Eight::Load(bins[axis][bin]));
      after[bin] = GetAreaOf(bounds);
    }
    bounds = NoBounds();
    int left = 0;
    for (int bin = 0; bin < GridBins - 1; ++bin)
    {
      bounds = vtkRelievoMin(bounds, Eight::Load(bins[axis][bin]));
      left += counts[axis][bin];
      if (left > 0 && left < count)
      {
        const float cost = GetAreaOf(bounds) * static_cast<float>(left) +
          after[bin + 1] * static_cast<float>(count - left);
        if (cost < best.Cost)
        {
          best = { axis, bin, left, cost };
        }
      }
    }
  }
  const int most = FillLeaves(count, this->LeafSize) - this->LeafSize;
  if (best.Axis < 0) // all boxes have one position
  {
    return std::min(FillLeaves(count / 2, this->LeafSize), most);
  }
  // The greatest middle in the left bins.
  const int axis = best.Axis;
  const auto getBin = [&](int distance) {
    const auto factor = static_cast<std::uint16_t>(factors[axis]);
    return static_cast<int>((static_cast<std::uint32_t>(distance * enlarge[axis]) * factor) >> 16);
  };
  int least = 0;
  for (int above = highs[axis] - lows[axis] + 1; least + 1 < above;)
  {
    const int tried = (least + above) / 2;
    (getBin(tried) <= best.Bin ? least : above) = tried;
  }
  const int last = lows[axis] + least;
  Record* next = records + range.First;
  for (Record* record = next; record != records + end; ++record) // without branches
  {
    const Record moved = *record;
    *record = *next;
    *next = moved;
    next += GetMiddle(moved, axis) <= last ? 1 : 0;
  }
  const int whole = std::min(FillLeaves(best.Left, this->LeafSize), most);
  this->Move(range.First, range.First + best.Left, range.First + whole, end, axis);
  return whole;
}

//------------------------------------------------------------------------------
// Moves the border of two parts, `from`, by a few boxes: those with the least middles of the right
// part, or the greatest of the left part.
void vtkRelievoBoxRecords::Move(int first, int from, int to, int end, int axis)
{
  Record* const records = this->All.get();
  const auto isBefore = [axis](const Record& a, const Record& b) {
    const int x = GetMiddle(a, axis);
    const int y = GetMiddle(b, axis);
    return x < y || (x == y && a.Index < b.Index);
  };
  for (; from < to; ++from)
  {
    std::swap(records[from], *std::min_element(records + from, records + end, isBefore));
  }
  for (; from > to; --from)
  {
    std::swap(records[from - 1], *std::max_element(records + first, records + from, isBefore));
  }
}

//------------------------------------------------------------------------------
std::vector<int> vtkRelievoBoxRecords::TakeIndices()
{
  // Packed and shrunk in place first, so that records and indices do not take memory together.
  const auto count = static_cast<std::size_t>(this->Count);
  Record* const records = this->All.release();
  int* packed = reinterpret_cast<int*>(records);
  for (std::size_t i = 0; i < count; ++i)
  {
    const int index = records[i].Index;
    packed[i] = index;
  }
  void* const shrunk = std::realloc(static_cast<void*>(records), sizeof(int) * count + 1);
  const std::unique_ptr<void, decltype(&std::free)> kept(shrunk ? shrunk : records, &std::free);
  packed = static_cast<int*>(kept.get());
  return std::vector<int>(packed, packed + count);
}
