// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockLabels.h
 * @brief The labels of a box of blocks and of the layer of blocks around it.
 */
#ifndef vtkRelievoBlockLabels_h
#define vtkRelievoBlockLabels_h

#include "vtkType.h"

#include <array>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkUnsignedCharArray;

namespace relievo
{
/** Bits of a slice of blocks: rows of 64-bit words, with a word of zeros after each. */
struct BitSlice
{
  using Word = vtkTypeUInt64;

  int Words = 0; // per row
  std::vector<Word> Bits;

  void Resize(int rows, int words)
  {
    this->Words = words;
    this->Bits.assign(static_cast<std::size_t>(rows) * words, 0);
  }
  Word* Row(int row) { return this->Bits.data() + static_cast<std::size_t>(row) * this->Words; }
  const Word* Row(int row) const
  {
    return this->Bits.data() + static_cast<std::size_t>(row) * this->Words;
  }
};

/**
 * Blocks are numbered from 1 to Size in each direction; 0 and Size + 1 are the surrounding layer:
 * air if the side is closed, otherwise a copy of the blocks at that side, so that no face lies
 * between.
 */
struct BlockBox
{
  std::array<int, 3> Size = {};
  std::array<bool, 6> Closed = {}; // -x +x -y +y -z +z
};

class BlockLabels
{
public:
  virtual ~BlockLabels() = default;

  /**
   * Blocks of a one-component integer array, x fastest; null for other arrays. Blocks whose ghost
   * value has one of the bits of `hiding` are air.
   */
  static std::unique_ptr<BlockLabels> New(vtkDataArray* labels, const BlockBox& box,
    vtkTypeInt64 air, vtkUnsignedCharArray* ghosts, unsigned char hiding);

  /** The label of a block. */
  vtkTypeInt64 Label(int i, int j, int k) const { return this->LabelAt(this->Index(i, j, k)); }

  /** The label at an index of the array; that of air for -1 and for hidden blocks. */
  virtual vtkTypeInt64 LabelAt(vtkIdType index) const = 0;

  /** Marks the blocks of a slice that are not air: a row of bits for each row of blocks. */
  virtual void GetSolid(int k, BitSlice& solid) const = 0;

  /**
   * Marks differing labels of a slice: bit i of `x` compares blocks i and i + 1; row j of `y`
   * compares rows j and j + 1; `z` compares slices k - 1 and k (k at least 1).
   */
  virtual void GetBorders(int k, BitSlice& x, BitSlice& y, BitSlice& z) const = 0;

  /** Whether the labels' type can hold the label of air. */
  virtual bool CanHoldAir() const = 0;

  /** The index of a block in the array; -1 for a block of a closed layer. */
  vtkIdType Index(int i, int j, int k) const;

  /** The index of the adjacent block along an axis; -1 for air outside. */
  vtkIdType Beside(vtkIdType index, int axis, bool above) const;

  int Words() const { return (this->Box.Size[0] + 2 + 63) / 64 + 1; }
  const BlockBox& GetBox() const { return this->Box; }

protected:
  explicit BlockLabels(const BlockBox& box)
    : Box(box)
  {
  }
  int Inside(int axis, int index) const; // -1: air

  BlockBox Box;
};
}

#endif
