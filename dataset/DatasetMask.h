// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixels of a picture that belong to an object.
 */
#ifndef DatasetMask_h
#define DatasetMask_h

#include "DatasetNames.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace dataset
{
class DatasetMask
{
public:
  DatasetMask(int columns, int rows)
    : Columns(static_cast<std::size_t>(columns))
    , Rows(static_cast<std::size_t>(rows))
  {
  }

  /// Adds pixels, numbered row by row from the top, in increasing order; repeated ones count once.
  void Add(std::size_t pixel);

  std::size_t GetCount() const { return this->Count; }

  /// First column and row, columns and rows; all -1 for an empty mask.
  std::array<int, 4> GetBox() const;

  /// One byte per pixel, row by row from the top: 0 or this value.
  std::vector<unsigned char> GetBytes(unsigned char value) const;

  /// COCO's run lengths as text: background and mask in turn, column by column.
  std::string GetRuns() const;

  /// Calls a function with each pixel.
  template <typename Call>
  void ForEach(const Call& call) const
  {
    for (const auto& [first, end] : this->Spans)
    {
      for (std::size_t pixel = first; pixel < end; ++pixel)
      {
        call(pixel);
      }
    }
  }

private:
  std::size_t Columns, Rows, Count = 0;
  std::vector<std::pair<std::size_t, std::size_t>> Spans; // pixel ranges, the end excluded, each
                                                          // within a row
};
}

#endif
