// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCaveImage.h"

#include "vtkRelievoCaveNoise.h"

#include "vtkRelievoThreads.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace relievo
{
namespace
{
constexpr int RowBatch = 64; // rows of blocks between two reports of progress

// Bound of two noises' difference due to rounding: 5e8 cells from the origin, the positions of a
// sample and of its block's middle are off by at most 6e-7 cells together; the slope is 7.8.
constexpr double Rounding = 5e-6;

// Half the block size along each axis, in cells: larger blocks are rarely proven to be rock.
constexpr double HalfBlock = 0.03;

// Writes samples; a sample whose WallOf exceeds `Limit` is rock.
struct MaskWriter
{
  static constexpr double Limit = 0.;
  unsigned char Air;
  unsigned char Rock;
  unsigned char* Values;

  void SetRock(vtkIdType first, vtkIdType count) const
  {
    std::fill(this->Values + first, this->Values + first + count, this->Rock);
  }
  bool Set(vtkIdType sample, double wall) const
  {
    this->Values[sample] = wall < 0. ? this->Air : this->Rock;
    return wall < 0.;
  }
};

struct DensityWriter
{
  static constexpr double Limit = 1.;
  float* Values;

  void SetRock(vtkIdType first, vtkIdType count) const
  {
    std::fill(this->Values + first, this->Values + first + count, 1.f);
  }
  bool Set(vtkIdType sample, double wall) const
  {
    this->Values[sample] = static_cast<float>(wall);
    return wall < 0.;
  }
};

template <typename Writer>
class Sampler
{
public:
  Sampler(const CaveGrid& grid, const CaveSettings& settings, const Writer& writer)
    : Grid(grid)
    , Settings(settings)
    , Write(writer)
  {
    double squares = 0.;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] = grid.Extent[2 * axis + 1] - grid.Extent[2 * axis] + 1;
      const double step = std::abs(grid.Spacing[axis] * settings.Field.Cells[axis]);
      const double most = std::min(2. * HalfBlock / step + 1., 64.);
      this->Block[axis] = settings.Skipping ? std::max(static_cast<int>(most), 1) : 64;
      this->Block[axis] = std::min(this->Block[axis], this->Size[axis]);
      this->Blocks[axis] = (this->Size[axis] + this->Block[axis] - 1) / this->Block[axis];
      const double half = 0.5 * (this->Block[axis] - 1) * step;
      squares += half * half;
    }
    const double slope = f64::relievoSimplexNoiseSlope * settings.Field.PerHalf;
    this->Margin = Rounding * settings.Field.PerHalf;
    this->PerStep = 1. / (slope * std::abs(grid.Spacing[0] * settings.Field.Cells[0]));
    this->BlockRise = slope * std::sqrt(squares);
    // Blocks of only a few samples do not repay their own evaluation.
    this->UsesBlocks = settings.Skipping && this->Block[0] * this->Block[1] * this->Block[2] >= 12;
  }

  CaveCounts Run() const
  {
    CaveCounts counts;
    std::atomic<vtkTypeInt64> evaluations(0);
    std::atomic<vtkTypeInt64> air(0);
    const vtkIdType rows = static_cast<vtkIdType>(this->Blocks[1]) * this->Blocks[2];
    for (vtkIdType batch = 0; batch < rows && !counts.Stopped; batch += RowBatch)
    {
      const vtkIdType end = std::min(batch + RowBatch, rows);
      vtkRelievoWithThreads([&]() {
        vtkSMPTools::For(batch, end, 1, [&](vtkIdType first, vtkIdType last) {
          CaveCounts mine;
          for (vtkIdType row = first; row < last; ++row)
          {
            this->MakeRow(static_cast<int>(row % this->Blocks[1]),
              static_cast<int>(row / this->Blocks[1]), mine);
          }
          evaluations += mine.Evaluations;
          air += mine.Air;
        });
      });
      counts.Stopped = this->Settings.GoOn &&
        !this->Settings.GoOn(static_cast<double>(end) / static_cast<double>(rows));
    }
    counts.Evaluations = evaluations;
    counts.Air = air;
    return counts;
  }

private:
  CavePlace PlaceAt(int i, int j, int k) const
  {
    const int* extent = this->Grid.Extent.data();
    return this->Settings.Field.PlaceOf(
      this->Grid.PointAt(extent[0] + i, extent[2] + j, extent[4] + k).data());
  }

  // Makes the samples of a row of blocks along x.
  void MakeRow(int blockY, int blockZ, CaveCounts& counts) const
  {
    const int y[2] = { blockY * this->Block[1],
      std::min((blockY + 1) * this->Block[1], this->Size[1]) };
    const int z[2] = { blockZ * this->Block[2],
      std::min((blockZ + 1) * this->Block[2], this->Size[2]) };
    const auto isRock = [&](int x) {
      return this->UsesBlocks && this->IsRock(x, y[0], z[0], counts);
    };
    bool rock = isRock(0);
    for (int x = 0; x < this->Size[0];)
    {
      int end = std::min(x + this->Block[0], this->Size[0]);
      const bool fill = rock;
      rock = end < this->Size[0] && isRock(end);
      // Joins adjacent unproven blocks, so that steps along them can be long.
      while (!fill && !rock && end < this->Size[0])
      {
        end = std::min(end + this->Block[0], this->Size[0]);
        rock = end < this->Size[0] && isRock(end);
      }
      for (int k = z[0]; k < z[1]; ++k)
      {
        for (int j = y[0]; j < y[1]; ++j)
        {
          if (fill)
          {
            this->Write.SetRock(this->SampleAt(x, j, k), end - x);
          }
          else
          {
            this->MakeSamples(x, end, j, k, counts);
          }
        }
      }
      x = end;
    }
  }

  vtkIdType SampleAt(int i, int j, int k) const
  {
    return i + this->Size[0] * (j + this->Size[1] * static_cast<vtkIdType>(k));
  }

  // Whether the noises in the middle of a block prove that the whole block is rock.
  bool IsRock(int x, int y, int z, CaveCounts& counts) const
  {
    const CavePlace first = this->PlaceAt(x, y, z);
    const CavePlace last =
      this->PlaceAt(x + this->Block[0] - 1, y + this->Block[1] - 1, z + this->Block[2] - 1);
    const CavePlace middle = { 0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1]),
      0.5 * (first[2] + last[2]) };
    const CaveField& field = this->Settings.Field;
    const double needed = Writer::Limit + this->BlockRise + this->Margin;
    for (int which = 0; which < 2; ++which)
    {
      ++counts.Evaluations;
      if (field.WallOf(CaveNoise(field, middle, which).Value()) > needed)
      {
        return true;
      }
    }
    return false;
  }

  void MakeSamples(int first, int end, int j, int k, CaveCounts& counts) const
  {
    const CaveField& field = this->Settings.Field;
    for (int i = first; i < end;)
    {
      const vtkIdType sample = this->SampleAt(i, j, k);
      const CavePlace place = this->PlaceAt(i, j, k);
      double wall = -1.;
      for (int which = 0; which < 2 && wall < Writer::Limit; ++which)
      {
        wall = std::max(wall, field.WallOf(CaveNoise(field, place, which).Value()));
        ++counts.Evaluations;
      }
      if (wall < Writer::Limit)
      {
        counts.Air += this->Write.Set(sample, wall);
        ++i;
        continue;
      }
      // The noise cannot return to the limit within this many samples: they are rock.
      const double steps = (wall - Writer::Limit - this->Margin) * this->PerStep;
      const int more =
        this->Settings.Skipping && steps > 0. ? static_cast<int>(std::min(steps, 1e6)) : 0;
      const int next = std::min(i + 1 + more, end);
      this->Write.SetRock(sample, next - i);
      i = next;
    }
  }

  const CaveGrid& Grid;
  const CaveSettings& Settings;
  const Writer Write;
  int Size[3];
  int Block[3];  // samples
  int Blocks[3]; // along each axis
  double Margin;
  double PerStep;   // samples along x within which WallOf changes by at most 1
  double BlockRise; // bound of WallOf's change from the middle of a block
  bool UsesBlocks;
};
}

//------------------------------------------------------------------------------
CaveCounts MakeCaveMask(const CaveGrid& grid, const CaveSettings& settings, unsigned char air,
  unsigned char rock, unsigned char* values)
{
  return Sampler<MaskWriter>(grid, settings, { air, rock, values }).Run();
}

//------------------------------------------------------------------------------
CaveCounts MakeCaveDensity(const CaveGrid& grid, const CaveSettings& settings, float* values)
{
  return Sampler<DensityWriter>(grid, settings, { values }).Run();
}
}
