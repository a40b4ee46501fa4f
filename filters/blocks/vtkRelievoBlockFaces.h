// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockFaces.h
 * @brief Bits that mark the faces of a slice of blocks that belong to the surface, and the vertices
 * that they use.
 */
#ifndef vtkRelievoBlockFaces_h
#define vtkRelievoBlockFaces_h

#include "vtkRelievoBlockLabels.h"

namespace relievo
{
/** Selects the faces to make. */
struct FaceChoice
{
  bool BetweenLabels = false; // also between two labels other than air
  // Blocks, numbered as in BlockBox, whose faces are made. A face belongs to the lower of its
  // blocks, unless that is air.
  std::array<int, 6> Owners = {};
};

/** Faces of one slice k of blocks, and those between it and the slice below. */
struct FaceSlice
{
  BitSlice Solid;
  BitSlice X; // row j, bit i: between blocks i and i + 1
  BitSlice Y; // row j, bit i: between rows j and j + 1
  BitSlice Z; // row j, bit i: between slices k - 1 and k

  /** Makes slice k. `below` is slice k - 1, unless k is 0. */
  void Make(const BlockLabels& labels, const FaceChoice& choice, int k, const FaceSlice* below);

  vtkIdType Count() const;
};

/**
 * Vertices of faces in the plane between slices k and k + 1: vertex i is between blocks i, i + 1.
 */
struct VertexSlice
{
  BitSlice Used;           // a row for each vertex row j, between rows j and j + 1 of blocks
  std::vector<int> Before; // vertices in all words before a word
  int Count = 0;

  void Make(const BlockBox& box, const FaceSlice& lower, const FaceSlice& upper);

  /** The number of a used vertex within its slice. */
  int Number(int i, int j) const
  {
    const std::size_t word = static_cast<std::size_t>(j) * this->Used.Words + i / 64;
    const BitSlice::Word below = (BitSlice::Word(1) << (i & 63)) - 1;
    return this->Before[word] + static_cast<int>(CountBits(this->Used.Bits[word] & below));
  }

  static std::size_t CountBits(BitSlice::Word word)
  {
    word -= word >> 1 & 0x5555555555555555u;
    word = (word & 0x3333333333333333u) + (word >> 2 & 0x3333333333333333u);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return word * 0x0101010101010101u >> 56;
  }
};

/** The row shifted by one: bit i is the row's bit i + 1. The row ends with a word of zeros. */
inline BitSlice::Word NextBits(const BitSlice::Word* row, int word, int words)
{
  return row[word] >> 1 | (word + 1 < words ? row[word + 1] << 63 : 0);
}

/**
 * Calls each(axis, j, word, bits of four faces) for every word of the edges between slices k - 1
 * and k, and of those along z in slice k: bit i is the edge at block i of row j.
 */
template <typename Each>
void ForEachEdges(const FaceSlice& lower, const FaceSlice& upper, int lastRow, Each&& each)
{
  using Word = BitSlice::Word;
  const int words = upper.X.Words;
  const auto run = [&](int axis, int j, const Word* a, const Word* b, const Word* c, bool shifted,
                     const Word* d) {
    for (int word = 0; word < words; ++word)
    {
      // For edges along y or z, the fourth face is that of the next block.
      const Word fourth = shifted ? NextBits(d, word, words) : d[word];
      each(axis, j, word, std::array<Word, 4>{ { a[word], b[word], c[word], fourth } });
    }
  };
  for (int j = 0; j <= lastRow; ++j)
  {
    run(0, j, lower.Y.Row(j), upper.Y.Row(j), upper.Z.Row(j), false, upper.Z.Row(j + 1));
    run(1, j, lower.X.Row(j), upper.X.Row(j), upper.Z.Row(j), true, upper.Z.Row(j));
    run(2, j, upper.X.Row(j), upper.X.Row(j + 1), upper.Y.Row(j), true, upper.Y.Row(j));
  }
}

/** The edges of a word that some faces use, but not exactly two. */
inline BitSlice::Word SeamsOf(const std::array<BitSlice::Word, 4>& faces)
{
  return (faces[0] ^ faces[1] ^ faces[2] ^ faces[3]) | (faces[0] & faces[1] & faces[2] & faces[3]);
}

/** Calls each(i) for every bit that is set in a row, in order. */
template <typename Each>
void ForEachBit(const BitSlice::Word* row, int words, Each&& each)
{
  for (int word = 0; word < words; ++word)
  {
    for (BitSlice::Word left = row[word]; left; left &= left - 1)
    {
      const BitSlice::Word lowest = left & (~left + 1);
      each(64 * word + static_cast<int>(VertexSlice::CountBits(lowest - 1)));
    }
  }
}
}

#endif
