// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockLabels.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <type_traits>

namespace relievo
{
//------------------------------------------------------------------------------
int BlockLabels::Inside(int axis, int index) const
{
  const int size = this->Box.Size[axis];
  if (index >= 1 && index <= size)
  {
    return index - 1;
  }
  return this->Box.Closed[2 * axis + (index < 1 ? 0 : 1)] ? -1 : (index < 1 ? 0 : size - 1);
}

//------------------------------------------------------------------------------
vtkIdType BlockLabels::Index(int i, int j, int k) const
{
  const vtkIdType x = this->Inside(0, i);
  const vtkIdType y = this->Inside(1, j);
  const vtkIdType z = this->Inside(2, k);
  return x < 0 || y < 0 || z < 0 ? -1 : x + this->Box.Size[0] * (y + this->Box.Size[1] * z);
}

//------------------------------------------------------------------------------
vtkIdType BlockLabels::Beside(vtkIdType index, int axis, bool above) const
{
  int place[3];
  for (int i = 0; i < 3; ++i)
  {
    place[i] = static_cast<int>(index % this->Box.Size[i]) + 1;
    index /= this->Box.Size[i];
  }
  place[axis] += above ? 1 : -1;
  return this->Index(place[0], place[1], place[2]);
}

namespace
{
// Bit i of the words tells whether test(i) holds. Fills bytes first, as compilers vectorise that.
template <typename Test>
void PackBits(int count, BitSlice::Word* words, Test&& test)
{
  for (int first = 0; first < count; first += 64)
  {
    const int end = std::min(64, count - first);
    unsigned char bytes[64] = {};
    for (int i = 0; i < end; ++i)
    {
      bytes[i] = test(first + i);
    }
    BitSlice::Word word = 0;
    for (int group = 0; group < 8; ++group)
    {
      BitSlice::Word eight = 0;
      for (int i = 0; i < 8; ++i)
      {
        eight |= static_cast<BitSlice::Word>(bytes[8 * group + i]) << 8 * i;
      }
      // The product moves the lowest bit of byte i to bit 56 + i.
      word |= (eight * 0x0102040810204080u >> 56) << 8 * group;
    }
    words[first / 64] = word;
  }
}

// Moves all bits up by one: bit 0 becomes 0.
void ShiftUp(BitSlice::Word* words, int count)
{
  for (int word = count - 1; word >= 0; --word)
  {
    words[word] = words[word] << 1 | (word > 0 ? words[word - 1] >> 63 : 0);
  }
}

template <typename T>
class LabelsOf : public BlockLabels
{
public:
  LabelsOf(const T* values, const BlockBox& box, vtkTypeInt64 air, const unsigned char* ghosts,
    unsigned char hiding)
    : BlockLabels(box)
    , Values(values)
    , Ghosts(ghosts)
    , Hiding(hiding)
    , Air(static_cast<T>(air))
  {
    this->HasAir = static_cast<vtkTypeInt64>(this->Air) == air;
    this->AirLabel = air;
  }

  vtkTypeInt64 LabelAt(vtkIdType index) const override
  {
    return index < 0 || this->IsHidden(index) ? this->AirLabel
                                              : static_cast<vtkTypeInt64>(this->Values[index]);
  }

  bool CanHoldAir() const override { return this->HasAir; }

  void GetSolid(int k, BitSlice& solid) const override
  {
    const int width = this->Box.Size[0];
    for (int j = 0; j < this->Box.Size[1] + 2; ++j)
    {
      BitSlice::Word* words = solid.Row(j);
      std::fill(words, words + solid.Words, BitSlice::Word(0));
      const vtkIdType start = this->Index(1, j, k);
      if (start < 0)
      {
        continue;
      }
      const T* row = this->Values + start;
      const T air = this->Air;
      if (this->Ghosts || !this->HasAir)
      {
        PackBits(width, words,
          [&](int i) { return (!this->HasAir || row[i] != air) && !this->IsHidden(start + i); });
      }
      else
      {
        PackBits(width, words, [row, air](int i) { return row[i] != air; });
      }
      // Bit 0 is the surrounding layer; the row itself begins at bit 1.
      ShiftUp(words, solid.Words);
      this->SetBit(words, 0, this->Label(0, j, k) != this->AirLabel);
      this->SetBit(words, width + 1, this->Label(width + 1, j, k) != this->AirLabel);
    }
  }

  void GetBorders(int k, BitSlice& x, BitSlice& y, BitSlice& z) const override
  {
    if (this->HasAir)
    {
      this->template GetBordersAs<T>(k, x, y, z);
    }
    else
    {
      this->template GetBordersAs<vtkTypeInt64>(k, x, y, z);
    }
  }

private:
  bool IsHidden(vtkIdType index) const
  {
    return this->Ghosts && (this->Ghosts[index] & this->Hiding);
  }
  static void SetBit(BitSlice::Word* words, int bit, bool value)
  {
    const BitSlice::Word mask = BitSlice::Word(1) << (bit & 63);
    words[bit / 64] = value ? words[bit / 64] | mask : words[bit / 64] & ~mask;
  }

  // Uses rows of a type that holds every label, including air.
  template <typename Id>
  void GetBordersAs(int k, BitSlice& x, BitSlice& y, BitSlice& z) const
  {
    const int width = this->Box.Size[0] + 2;
    std::vector<Id> row(width);
    std::vector<Id> next(width);
    std::vector<Id> below(width);
    this->GetRow(0, k, next);
    for (int j = 0; j < this->Box.Size[1] + 2; ++j)
    {
      std::swap(row, next);
      const Id* labels = row.data();
      PackBits(width - 1, x.Row(j), [labels](int i) { return labels[i] != labels[i + 1]; });
      if (j < this->Box.Size[1] + 1)
      {
        this->GetRow(j + 1, k, next);
        const Id* others = next.data();
        PackBits(width, y.Row(j), [labels, others](int i) { return labels[i] != others[i]; });
      }
      if (k > 0)
      {
        this->GetRow(j, k - 1, below);
        const Id* others = below.data();
        PackBits(width, z.Row(j), [labels, others](int i) { return labels[i] != others[i]; });
      }
    }
  }

  template <typename Id>
  void GetRow(int j, int k, std::vector<Id>& row) const
  {
    const int width = this->Box.Size[0];
    const vtkIdType start = this->Index(1, j, k);
    if (start < 0)
    {
      std::fill(row.begin(), row.end(), static_cast<Id>(this->AirLabel));
      return;
    }
    row.front() = static_cast<Id>(this->Label(0, j, k));
    row.back() = static_cast<Id>(this->Label(width + 1, j, k));
    std::copy(this->Values + start, this->Values + start + width, row.begin() + 1);
    for (int i = 0; this->Ghosts && i < width; ++i)
    {
      row[i + 1] = this->IsHidden(start + i) ? static_cast<Id>(this->AirLabel) : row[i + 1];
    }
  }

  const T* Values;
  const unsigned char* Ghosts;
  unsigned char Hiding;
  T Air;
  vtkTypeInt64 AirLabel = 0;
  bool HasAir = true; // the type can hold the label of air
};
}

//------------------------------------------------------------------------------
std::unique_ptr<BlockLabels> BlockLabels::New(vtkDataArray* labels, const BlockBox& box,
  vtkTypeInt64 air, vtkUnsignedCharArray* ghosts, unsigned char hiding)
{
  bool hides = false;
  for (vtkIdType i = 0; ghosts && !hides && i < ghosts->GetNumberOfValues(); ++i)
  {
    hides = ghosts->GetValue(i) & hiding;
  }
  const unsigned char* hidden = hides ? ghosts->GetPointer(0) : nullptr;
  switch (labels->GetDataType())
  {
    vtkTemplateMacro(if constexpr (std::is_integral<VTK_TT>::value) {
      return std::make_unique<LabelsOf<VTK_TT>>(
        static_cast<const VTK_TT*>(labels->GetVoidPointer(0)), box, air, hidden, hiding);
    });
  }
  return nullptr;
}
}
