// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetMask.h"

#include <algorithm>

namespace dataset
{
//------------------------------------------------------------------------------
void DatasetMask::Add(std::size_t pixel)
{
  const bool follows = !this->Spans.empty();
  if (follows && pixel < this->Spans.back().second)
  {
    return;
  }
  if (follows && pixel == this->Spans.back().second && pixel % this->Columns != 0)
  {
    ++this->Spans.back().second;
  }
  else
  {
    this->Spans.emplace_back(pixel, pixel + 1);
  }
  ++this->Count;
}

//------------------------------------------------------------------------------
std::array<int, 4> DatasetMask::GetBox() const
{
  if (this->Spans.empty())
  {
    return { -1, -1, -1, -1 };
  }
  std::size_t left = this->Columns;
  std::size_t right = 0;
  for (const auto& [first, end] : this->Spans)
  {
    left = std::min(left, first % this->Columns);
    right = std::max(right, (end - 1) % this->Columns);
  }
  const std::size_t top = this->Spans.front().first / this->Columns;
  const std::size_t bottom = this->Spans.back().first / this->Columns;
  return { static_cast<int>(left), static_cast<int>(top), static_cast<int>(right - left + 1),
    static_cast<int>(bottom - top + 1) };
}

//------------------------------------------------------------------------------
std::vector<unsigned char> DatasetMask::GetBytes(unsigned char value) const
{
  std::vector<unsigned char> bytes(this->Columns * this->Rows);
  this->ForEach([&](std::size_t pixel) { bytes[pixel] = value; });
  return bytes;
}

//------------------------------------------------------------------------------
// COCO writes a length minus the second-last one, in groups of five bits from the lowest, each as a
// letter from '0' on; a sixth bit means that more follow, and the last group has the sign.
std::string DatasetMask::GetRuns() const
{
  std::vector<long> lengths;
  const std::array<int, 4> box = this->GetBox();
  const std::vector<unsigned char> bytes = this->GetBytes(1);
  std::size_t begin = 0; // start of the run, column by column
  unsigned char is = 0;
  const auto end = [&](std::size_t place) {
    lengths.push_back(static_cast<long>(place - begin));
    begin = place;
    is = 1 - is;
  };
  for (int column = box[0]; this->Count > 0 && column < box[0] + box[2]; ++column)
  {
    for (std::size_t row = 0; row < this->Rows; ++row)
    {
      const auto at = static_cast<std::size_t>(column);
      if (bytes[row * this->Columns + at] != is)
      {
        end(at * this->Rows + row);
      }
    }
  }
  const std::size_t after = this->Count > 0 ? static_cast<std::size_t>(box[0] + box[2]) : 0;
  if (is != 0 && after < this->Columns)
  {
    end(after * this->Rows);
  }
  if (begin < this->Columns * this->Rows)
  {
    end(this->Columns * this->Rows);
  }
  std::string text;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    long rest = lengths[i] - (i > 2 ? lengths[i - 2] : 0);
    bool more = true;
    while (more)
    {
      const long bits = rest & 31;
      rest >>= 5;
      more = rest != ((bits & 16) != 0 ? -1 : 0);
      text += static_cast<char>('0' + bits + (more ? 32 : 0));
    }
  }
  return text;
}
}
