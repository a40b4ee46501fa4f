// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockSlab.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoNoiseCell.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo
{
//------------------------------------------------------------------------------
std::array<double, 3> AreaOf(int axis, const BlockRule::Offset* const corners[4])
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  double across[2][3];
  for (int i = 0; i < 3; ++i)
  {
    across[0][i] = (*corners[2])[i] - (*corners[0])[i];
    across[1][i] = (*corners[3])[i] - (*corners[1])[i];
  }
  across[0][u] += 1.;
  across[0][v] += 1.;
  across[1][u] -= 1.;
  across[1][v] += 1.;
  std::array<double, 3> area;
  vtkMath::Cross(across[0], across[1], area.data());
  return area;
}

//------------------------------------------------------------------------------
BlockSlab::BlockSlab(const BlockLabels& labels, const BlockSettings& settings,
  const BlockRule& rule, BlockSurface& surface)
  : Labels(labels)
  , Settings(settings)
  , Rule(rule)
  , Surface(surface)
  , NeedsLabels(settings.Faces.BetweenLabels || !settings.Rigid.empty() || !settings.Level.empty())
{
  double transposed[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Metric[axis] = 0.;
    for (int row = 0; row < 3; ++row)
    {
      transposed[axis][row] = settings.Axes[row][axis];
      this->Metric[axis] += transposed[axis][row] * transposed[axis][row];
    }
  }
  this->Mirrored = vtkMath::Determinant3x3(transposed) < 0.;
  vtkMath::Invert3x3(transposed, this->NormalAxes);
}

//------------------------------------------------------------------------------
void BlockSlab::Begin(int first, const std::vector<vtkIdType>& starts)
{
  this->Faces[1].Make(this->Labels, this->Settings.Faces, first - 1, nullptr);
  if (first > 1)
  {
    // Side faces of the slice below reach up to the first plane of vertices.
    this->Faces[0].Make(this->Labels, this->Settings.Faces, first - 2, nullptr);
    this->Faces[1].Make(this->Labels, this->Settings.Faces, first - 1, &this->Faces[0]);
    this->MakePlane(first - 2, this->Faces[0], this->Faces[1], this->Planes[0]);
  }
  this->Faces[2].Make(this->Labels, this->Settings.Faces, first, &this->Faces[1]);
  this->MakePlane(first - 1, this->Faces[1], this->Faces[2], this->Planes[1]);
  this->Planes[1].Start = starts[first];
  if (first > 1)
  {
    for (BitSlice::Word& word : this->Faces[1].Z.Bits)
    {
      word = 0;
    }
    this->MakeFaces(first - 1, false, 0);
  }
}

//------------------------------------------------------------------------------
void BlockSlab::Make(int k, const std::vector<vtkIdType>& starts, vtkIdType firstFace)
{
  std::swap(this->Faces[0], this->Faces[1]);
  std::swap(this->Faces[1], this->Faces[2]);
  std::swap(this->Planes[0], this->Planes[1]);
  if (k <= this->Labels.GetBox().Size[2])
  {
    this->Faces[2].Make(this->Labels, this->Settings.Faces, k + 1, &this->Faces[1]);
    this->MakePlane(k, this->Faces[1], this->Faces[2], this->Planes[1]);
    this->Planes[1].Start = starts[k + 1];
  }
  this->MakeFaces(k, true, firstFace);
  if (this->Settings.Seams)
  {
    this->MakeSeams(k);
  }
  this->WritePlane(k);
}

//------------------------------------------------------------------------------
void BlockSlab::MakePlane(int k, const FaceSlice& lower, const FaceSlice& upper, Plane& plane) const
{
  const BlockBox& box = this->Labels.GetBox();
  plane.Vertices.Make(box, lower, upper);
  plane.Offsets.clear();
  plane.Offsets.reserve(plane.Vertices.Count);
  for (int j = 0; j <= box.Size[1]; ++j)
  {
    ForEachBit(plane.Vertices.Used.Row(j), plane.Vertices.Used.Words,
      [&](int i) { plane.Offsets.push_back(this->OffsetOf(i, j, k, lower, upper)); });
  }
  plane.Areas.assign(this->Settings.Normals ? plane.Vertices.Count : 0, {});
}

//------------------------------------------------------------------------------
BlockRule::Offset BlockSlab::OffsetOf(
  int i, int j, int k, const FaceSlice& lower, const FaceSlice& upper) const
{
  BlockRule::Offset offset;
  bool noise = this->Settings.Noise.Amplitude != 0.;
  bool level = false;
  if (this->NeedsLabels)
  {
    std::array<vtkTypeInt64, 8> labels;
    for (int block = 0; block < 8; ++block)
    {
      labels[block] = this->Labels.Label(i + (block & 1), j + (block >> 1 & 1), k + (block >> 2));
      if (this->Settings.Rigid.count(labels[block]))
      {
        return {};
      }
      level = level || this->Settings.Level.count(labels[block]);
    }
    if (this->Settings.Faces.BetweenLabels)
    {
      offset = this->Rule.Of(labels);
    }
  }
  if (!this->Settings.Faces.BetweenLabels)
  {
    unsigned int solid = 0;
    int bit = 0;
    for (const FaceSlice* slice : { &lower, &upper })
    {
      for (int row = j; row < j + 2; ++row)
      {
        const BitSlice::Word* words = slice->Solid.Row(row);
        for (int block = i; block < i + 2; ++block)
        {
          solid |= static_cast<unsigned int>(words[block / 64] >> (block & 63) & 1u) << bit++;
        }
      }
    }
    offset = this->Rule.Of(solid);
  }
  const int up = this->Settings.Up;
  if (level)
  {
    // Level blocks also move half as far sideways: the full movement could fold faces whose other
    // vertices move up or down.
    for (double& value : offset)
    {
      value *= 0.5;
    }
    offset[up] = 0.;
    noise = false;
  }
  if (noise)
  {
    const BlockNoise& settings = this->Settings.Noise;
    const int vertex[] = { i, j, k };
    f64::ivec3 cell(0);
    f64::vec3 part(0.);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (axis != up || settings.Solid)
      {
        const NoiseCell place = NoiseCell::Of(
          (this->Settings.First[axis] + vertex[axis] + offset[axis]) / settings.Scale);
        cell[axis] = place.Cell;
        part[axis] = place.Part;
      }
    }
    offset[up] += settings.Amplitude * f64::relievoSimplexNoise(cell, part, settings.Seed);
  }
  return offset;
}

//------------------------------------------------------------------------------
void BlockSlab::MakeFaces(int k, bool write, vtkIdType face)
{
  const FaceSlice& slice = this->Faces[1];
  const int words = slice.X.Words;
  const BlockBox& box = this->Labels.GetBox();
  const auto isSolid = [](const FaceSlice& of, int i, int j) {
    return (of.Solid.Row(j)[i / 64] >> (i & 63) & 1u) != 0;
  };
  for (int j = 0; j <= box.Size[1]; ++j)
  {
    ForEachBit(slice.Z.Row(j), words,
      [&](int i) { this->MakeFace(2, i, j, k, isSolid(this->Faces[0], i, j), write, face); });
    ForEachBit(slice.X.Row(j), words,
      [&](int i) { this->MakeFace(0, i, j, k, isSolid(slice, i, j), write, face); });
    ForEachBit(slice.Y.Row(j), words,
      [&](int i) { this->MakeFace(1, i, j, k, isSolid(slice, i, j), write, face); });
  }
}

//------------------------------------------------------------------------------
void BlockSlab::MakeFace(int axis, int i, int j, int k, bool low, bool write, vtkIdType& face)
{
  // Vertices (i - 1 or i, j - 1 or j, below or above) around a block.
  static const int places[3][4][3] = {
    { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 1, 0, 1 } },
    { { 0, 1, 0 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 1, 0 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
  };
  Plane* planes[4];
  int numbers[4];
  const BlockRule::Offset* offsets[4];
  for (int corner = 0; corner < 4; ++corner)
  {
    const int* place = places[axis][corner];
    planes[corner] = &this->Planes[place[2]];
    numbers[corner] = planes[corner]->Vertices.Number(i - 1 + place[0], j - 1 + place[1]);
    offsets[corner] = &planes[corner]->Offsets[numbers[corner]];
  }
  if (this->Settings.Normals)
  {
    std::array<double, 3> area = AreaOf(axis, offsets);
    for (int corner = 0; corner < 4; ++corner)
    {
      std::array<double, 3>& sum = planes[corner]->Areas[numbers[corner]];
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += low ? area[c] : -area[c];
      }
    }
  }
  if (!write)
  {
    return;
  }
  BlockFace& result = this->Surface.Faces[face++];
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  double lengths[2] = { 0., 0. }; // squared, of both diagonals
  for (int c = 0; c < 3; ++c)
  {
    const double one = (*offsets[2])[c] - (*offsets[0])[c] + (c == u || c == v ? 1. : 0.);
    const double other = (*offsets[3])[c] - (*offsets[1])[c] + (c == v ? 1. : (c == u ? -1. : 0.));
    lengths[0] += this->Metric[c] * one * one;
    lengths[1] += this->Metric[c] * other * other;
  }
  const int first = lengths[1] < lengths[0] ? 1 : 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    // Seen from outside: in order if the axis points outwards, otherwise reversed.
    const bool inOrder = low != this->Mirrored;
    const int from = inOrder ? (first + corner) & 3 : (first + 4 - corner) & 3;
    result.Points[corner] = static_cast<vtkTypeUInt32>(planes[from]->Start + numbers[from]);
  }
  result.Owner = low ? this->Labels.Index(i, j, k - (axis == 2))
                     : this->Labels.Index(i + (axis == 0), j + (axis == 1), k);
  result.Axis = static_cast<unsigned char>(axis);
  result.Low = low;
  result.First = static_cast<unsigned char>(first);
}

//------------------------------------------------------------------------------
void BlockSlab::MakeSeams(int k)
{
  const int lastRow = this->Labels.GetBox().Size[1];
  ForEachEdges(this->Faces[0], this->Faces[1], lastRow,
    [&](int axis, int j, int word, const std::array<BitSlice::Word, 4>& faces) {
      const BitSlice::Word seams = SeamsOf(faces);
      ForEachBit(&seams, 1, [&](int bit) {
        int uses = 0;
        for (const BitSlice::Word face : faces)
        {
          uses += static_cast<int>(face >> bit & 1u);
        }
        this->AddSeam(axis, 64 * word + bit, j, k, uses);
      });
    });
}

//------------------------------------------------------------------------------
void BlockSlab::AddSeam(int axis, int i, int j, int k, int uses)
{
  // Block coordinates of both ends: vertex i is above block i.
  const std::array<int, 3> lower = { i - (axis == 0), j - (axis == 1), k - 1 };
  BlockSeam seam;
  seam.Vertex = lower;
  seam.Uses = uses;
  seam.Points[0] = this->Planes[0].Start + this->Planes[0].Vertices.Number(lower[0], lower[1]);
  const Plane& end = this->Planes[axis == 2 ? 1 : 0];
  seam.Points[1] = end.Start + end.Vertices.Number(i, j);
  this->Seams.push_back(seam);
}

//------------------------------------------------------------------------------
void BlockSlab::WritePlane(int k)
{
  const Plane& plane = this->Planes[0];
  const BlockSettings& settings = this->Settings;
  void* points =
    plane.Vertices.Count ? this->Surface.Points->GetVoidPointer(3 * plane.Start) : nullptr;
  float* normals = settings.Normals && plane.Vertices.Count
    ? this->Surface.Normals->GetPointer(3 * plane.Start)
    : nullptr;
  int number = 0;
  for (int j = 0; j <= this->Labels.GetBox().Size[1]; ++j)
  {
    ForEachBit(plane.Vertices.Used.Row(j), plane.Vertices.Used.Words, [&](int i) {
      const BlockRule::Offset& offset = plane.Offsets[number];
      const double block[] = { settings.First[0] + i + offset[0], settings.First[1] + j + offset[1],
        settings.First[2] + (k - 1) + offset[2] };
      for (int row = 0; row < 3; ++row)
      {
        const double value = settings.Origin[row] + settings.Axes[row][0] * block[0] +
          settings.Axes[row][1] * block[1] + settings.Axes[row][2] * block[2];
        if (settings.DoublePoints)
        {
          static_cast<double*>(points)[3 * number + row] = value;
        }
        else
        {
          static_cast<float*>(points)[3 * number + row] = static_cast<float>(value);
        }
      }
      if (this->Surface.Offsets.GetSize() > 0)
      {
        this->Surface.Offsets[plane.Start + number] = offset;
      }
      if (normals)
      {
        double normal[3];
        vtkMath::Multiply3x3(this->NormalAxes, plane.Areas[number].data(), normal);
        vtkMath::Normalize(normal);
        if (IsNull(plane.Areas[number]))
        {
          std::fill(normal, normal + 3, 0.);
          ++this->NullNormals;
        }
        for (int c = 0; c < 3; ++c)
        {
          normals[3 * number + c] = static_cast<float>(normal[c]);
        }
      }
      ++number;
    });
  }
}
}
