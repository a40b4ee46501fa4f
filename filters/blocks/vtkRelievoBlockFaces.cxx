// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockFaces.h"

#include <algorithm>

namespace relievo
{
namespace
{
using Word = BitSlice::Word;

// The bits from first to last of a word that begins with bit 64 * word.
Word Range(int first, int last, int word)
{
  const int from = std::max(first - 64 * word, 0);
  const int to = std::min(last - 64 * word, 63);
  return from > to ? 0 : (~Word(0) >> (63 - to)) & (~Word(0) << from);
}

bool IsIn(const int range[2], int index)
{
  return index >= range[0] && index <= range[1];
}

// Clears the borders between two rows of blocks that have no owner.
void KeepOwned(
  const BitSlice& lowSolid, int row, bool lowOwns, bool highOwns, const int range[2], Word* borders)
{
  const Word* solid = lowSolid.Row(row);
  for (int word = 0; word < lowSolid.Words; ++word)
  {
    const Word owned = (lowOwns ? solid[word] : 0) | (highOwns ? ~solid[word] : 0);
    borders[word] &= owned & Range(range[0], range[1], word);
  }
}
}

//------------------------------------------------------------------------------
void FaceSlice::Make(
  const BlockLabels& labels, const FaceChoice& choice, int k, const FaceSlice* below)
{
  const BlockBox& box = labels.GetBox();
  const int rows = box.Size[1] + 2;
  const int words = labels.Words();
  for (BitSlice* slice : { &this->Solid, &this->X, &this->Y, &this->Z })
  {
    slice->Resize(rows, words);
  }
  labels.GetSolid(k, this->Solid);
  if (choice.BetweenLabels)
  {
    labels.GetBorders(k, this->X, this->Y, this->Z);
  }
  else
  {
    for (int j = 0; j < rows; ++j)
    {
      const Word* solid = this->Solid.Row(j);
      const Word* next = j + 1 < rows ? this->Solid.Row(j + 1) : solid;
      const Word* under = below ? below->Solid.Row(j) : solid;
      for (int word = 0; word < words; ++word)
      {
        this->X.Row(j)[word] = solid[word] ^ NextBits(solid, word, words);
        this->Y.Row(j)[word] = solid[word] ^ next[word];
        this->Z.Row(j)[word] = solid[word] ^ under[word];
      }
    }
  }
  const int* owners = choice.Owners.data();
  const bool inSlice = IsIn(owners + 4, k);
  const bool underOwns = k > 0 && IsIn(owners + 4, k - 1);
  for (int j = 0; j < rows; ++j)
  {
    const bool inRow = IsIn(owners + 2, j);
    const Word* solid = this->Solid.Row(j);
    for (int word = 0; word < words; ++word)
    {
      const Word lows = solid[word] & Range(owners[0], owners[1], word);
      const Word highs = ~solid[word] & Range(owners[0] - 1, owners[1] - 1, word);
      this->X.Row(j)[word] &= inSlice && inRow ? lows | highs : 0;
    }
    const bool last = j + 1 == rows;
    KeepOwned(this->Solid, j, inSlice && inRow, inSlice && !last && IsIn(owners + 2, j + 1), owners,
      this->Y.Row(j));
    if (below)
    {
      KeepOwned(below->Solid, j, underOwns && inRow, inSlice && inRow, owners, this->Z.Row(j));
    }
    else
    {
      std::fill(this->Z.Row(j), this->Z.Row(j) + words, Word(0));
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType FaceSlice::Count() const
{
  vtkIdType count = 0;
  for (const BitSlice* slice : { &this->X, &this->Y, &this->Z })
  {
    for (const Word word : slice->Bits)
    {
      count += static_cast<vtkIdType>(VertexSlice::CountBits(word));
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void VertexSlice::Make(const BlockBox& box, const FaceSlice& lower, const FaceSlice& upper)
{
  const int rows = box.Size[1] + 1;
  const int words = lower.X.Words;
  this->Used.Resize(rows, words);
  this->Before.resize(static_cast<std::size_t>(rows) * words);
  this->Count = 0;
  for (int j = 0; j < rows; ++j)
  {
    const Word* x[] = { lower.X.Row(j), lower.X.Row(j + 1), upper.X.Row(j), upper.X.Row(j + 1) };
    const Word* across[] = { lower.Y.Row(j), upper.Y.Row(j), upper.Z.Row(j), upper.Z.Row(j + 1) };
    Word both = across[0][0] | across[1][0] | across[2][0] | across[3][0];
    for (int word = 0; word < words; ++word)
    {
      const int next = word + 1;
      const Word following =
        next < words ? across[0][next] | across[1][next] | across[2][next] | across[3][next] : 0;
      const Word used =
        x[0][word] | x[1][word] | x[2][word] | x[3][word] | both | both >> 1 | following << 63;
      both = following;
      this->Used.Row(j)[word] = used;
      this->Before[static_cast<std::size_t>(j) * words + word] = this->Count;
      this->Count += static_cast<int>(CountBits(used));
    }
  }
}
}
