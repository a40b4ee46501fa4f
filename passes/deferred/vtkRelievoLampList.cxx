// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampList.h"

#include "vtkRelievoLampShadows.h"
#include "vtkRelievoLamps.h"
#include "vtkRelievoThreads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Threads take lamps in pieces; their results are joined in the pieces' order.
constexpr vtkIdType PieceSize = 1024;

struct Piece
{
  std::vector<vtkRelievoLampList::Lamp> Lamps;
  std::vector<float> Texels;
  std::vector<vtkRelievoLampList::Lamp> Beside;
  std::vector<float> BesideTexels;
  bool White = true;
};

// The view, or the picture of which the view is a tile.
struct Frustum
{
  vtkRelievoSphereBounds Bounds;
  double Pixels[2];
};

class Taker
{
public:
  Taker(const vtkRelievoFrameCamera& view, const glm::dmat4& tileToPicture)
    : View(view)
    , Tile{ vtkRelievoSphereBounds(view.ViewToNDC),
      { static_cast<double>(view.Viewport[2]), static_cast<double>(view.Viewport[3]) } }
    , Picture{ vtkRelievoSphereBounds(tileToPicture * view.ViewToNDC),
      { view.Viewport[2] / tileToPicture[0][0], view.Viewport[3] / tileToPicture[1][1] } }
    , InTiles(tileToPicture != glm::dmat4(1.0))
  {
  }

  void Take(const double* row, vtkIdType number, float falloff, Piece& piece) const
  {
    const glm::dvec4 center = this->View.WorldToView * glm::dvec4(row[0], row[1], row[2], 1.0);
    vtkRelievoLampList::Lamp lamp;
    lamp.Sphere.Center = glm::dvec3(center);
    // Enlarged because shaders compute a pixel's position and distance in floats.
    lamp.Sphere.Radius = row[3] * (1.0 + 1e-5) + 1e-6 * glm::length(lamp.Sphere.Center);
    double rectangle[4] = { 0.0, 0.0, 0.0, 0.0 };
    const bool seen = this->Find(this->Tile, lamp.Sphere, rectangle);
    if (!seen && (!this->InTiles || vtkRelievoLamps::GetCastsOf(row) == 0.0))
    {
      return;
    }
    double whole[4];
    std::copy_n(rectangle, 4, whole);
    const bool inPicture = this->InTiles ? this->Find(this->Picture, lamp.Sphere, whole) : seen;
    if (!seen && !inPicture)
    {
      return;
    }
    std::copy_n(rectangle, 4, lamp.Rectangle);
    if (!seen)
    {
      std::fill_n(lamp.Rectangle, 4, 0.0f);
    }
    lamp.Row = row;
    lamp.Number = number;
    lamp.Size = inPicture ? std::abs(row[4]) * std::max({ row[5], row[6], row[7] }) *
        (whole[2] - whole[0]) * (whole[3] - whole[1])
                          : -1.0;
    (seen ? piece.Lamps : piece.Beside).push_back(lamp);
    std::vector<float>& texels = seen ? piece.Texels : piece.BesideTexels;
    for (int i = 0; i < 3; ++i)
    {
      texels.push_back(static_cast<float>(lamp.Sphere.Center[i]));
    }
    texels.push_back(static_cast<float>(row[3]));
    for (int i = 0; i < 3; ++i)
    {
      texels.push_back(static_cast<float>(row[4] * row[5 + i]));
    }
    texels.push_back(falloff);
    piece.White = piece.White && (!seen || (row[5] == row[6] && row[6] == row[7]));
  }

private:
  bool Find(
    const Frustum& frustum, const vtkRelievoSphereBounds::Sphere& sphere, double rectangle[4]) const
  {
    if (!frustum.Bounds.FindRectangle(sphere, this->View.Near, this->View.Far, rectangle))
    {
      return false;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      // In pixels; a rectangle that contains no pixel's centre lights nothing.
      const double half = 0.5 * frustum.Pixels[axis];
      const double first = std::ceil((rectangle[axis] + 1.0) * half - 0.501);
      const double last = std::floor((rectangle[axis + 2] + 1.0) * half - 0.499);
      if (last < first)
      {
        return false;
      }
    }
    return true;
  }

  const vtkRelievoFrameCamera& View;
  Frustum Tile;
  Frustum Picture;
  bool InTiles;
};

constexpr int TexelFloats = 8; // per lamp

// A lamp that may cast shadows.
struct Candidate
{
  const vtkRelievoLampList::Lamp* Lamp;
  const float* Texels;
  bool Always;
  double Strength;

  bool operator<(const Candidate& other) const
  {
    return this->Always != other.Always      ? this->Always
      : this->Lamp->Size != other.Lamp->Size ? this->Lamp->Size > other.Lamp->Size
                                             : this->Lamp->Number < other.Lamp->Number;
  }
};

// A shadow fades if its lamp exceeds the next lamp's size by less than this share.
constexpr double Fade = 0.1;
}

//------------------------------------------------------------------------------
void vtkRelievoLampList::Take(const vtkRelievoFrameCamera& view,
  const std::vector<vtkRelievoLamps*>& sets, const glm::dmat4& tileToPicture)
{
  this->Lamps.clear();
  this->Texels.clear();
  this->Beside.clear();
  this->BesideTexels.clear();
  this->Attenuations.clear();
  this->NumberGiven = 0;
  this->White = true;
  const Taker taker(view, tileToPicture);
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    const double* rows = sets[set]->GetSharedRows().data();
    const int width = sets[set]->GetRowWidth();
    const auto count = static_cast<vtkIdType>(sets[set]->GetSharedRows().size()) / width;
    // Codes: 0 linear, 1 inverse square; 2 and more for VTK's, one for each set.
    const int falloff = sets[set]->GetFalloff() == vtkRelievoLamps::VTK
      ? vtkRelievoLamps::VTK + static_cast<int>(set)
      : sets[set]->GetFalloff();
    std::vector<Piece> pieces(static_cast<std::size_t>((count + PieceSize - 1) / PieceSize));
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(pieces.size()), 1, [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType p = from; p < to; ++p)
        {
          const vtkIdType end = std::min(count, (p + 1) * PieceSize);
          for (vtkIdType i = p * PieceSize; i < end; ++i)
          {
            taker.Take(
              rows + i * width, this->NumberGiven + i, static_cast<float>(falloff), pieces[p]);
          }
        }
      });
    for (const Piece& piece : pieces)
    {
      this->Lamps.insert(this->Lamps.end(), piece.Lamps.begin(), piece.Lamps.end());
      this->Texels.insert(this->Texels.end(), piece.Texels.begin(), piece.Texels.end());
      this->Beside.insert(this->Beside.end(), piece.Beside.begin(), piece.Beside.end());
      this->BesideTexels.insert(
        this->BesideTexels.end(), piece.BesideTexels.begin(), piece.BesideTexels.end());
      this->White = this->White && piece.White;
    }
    this->NumberGiven += static_cast<int>(count);
    for (const double value : { sets[set]->GetAttenuationValues()[0],
           sets[set]->GetAttenuationValues()[1], sets[set]->GetAttenuationValues()[2], 0.0 })
    {
      this->Attenuations.push_back(static_cast<float>(value));
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoLampList vtkRelievoLampList::TakeCasting(int largest, std::vector<double>& strengths)
{
  vtkRelievoLampList casting;
  casting.Attenuations = this->Attenuations;
  casting.White = this->White;
  strengths.clear();
  std::vector<Candidate> candidates;
  int always = 0;
  const auto consider = [&](const std::vector<Lamp>& lamps, const std::vector<float>& texels) {
    for (std::size_t i = 0; i < lamps.size(); ++i)
    {
      const double casts = vtkRelievoLamps::GetCastsOf(lamps[i].Row);
      if (lamps[i].Size >= 0.0 && (casts > 0.0 || (casts < 0.0 && largest > 0)))
      {
        candidates.push_back({ &lamps[i], &texels[i * TexelFloats], casts > 0.0, 1.0 });
        always += casts > 0.0 ? 1 : 0;
      }
    }
  };
  consider(this->Lamps, this->Texels);
  consider(this->Beside, this->BesideTexels);
  const std::size_t most = std::min(
    { vtkRelievoCastingLamp::Most, always + largest, static_cast<int>(candidates.size()) });
  const std::size_t looked = std::min(most + 1, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + looked, candidates.end());
  std::vector<Candidate> chosen;
  for (std::size_t i = 0; i < most; ++i)
  {
    Candidate candidate = candidates[i];
    const bool alone = looked == most || candidate.Always != candidates[most].Always;
    const double next = alone ? 0.0 : candidates[most].Lamp->Size;
    candidate.Strength =
      next > 0.0 ? std::min((candidate.Lamp->Size / next - 1.0) / Fade, 1.0) : 1.0;
    if (candidate.Strength > 0.0)
    {
      chosen.push_back(candidate);
    }
  }
  std::sort(chosen.begin(), chosen.end(),
    [](const Candidate& a, const Candidate& b) { return a.Lamp->Number < b.Lamp->Number; });
  for (const Candidate& candidate : chosen)
  {
    casting.Lamps.push_back(*candidate.Lamp);
    casting.Texels.insert(casting.Texels.end(), candidate.Texels, candidate.Texels + TexelFloats);
    strengths.push_back(candidate.Strength);
  }
  for (const Lamp& lamp : casting.Lamps)
  {
    this->TakeOut(lamp.Number);
  }
  return casting;
}

//------------------------------------------------------------------------------
bool vtkRelievoLampList::IsLinear() const
{
  for (std::size_t last = TexelFloats - 1; last < this->Texels.size(); last += TexelFloats)
  {
    if (this->Texels[last] != 0.0f)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Removes the lamp of this number, if it is in view. Numbers ascend.
void vtkRelievoLampList::TakeOut(vtkIdType number)
{
  const auto lamp = std::lower_bound(this->Lamps.begin(), this->Lamps.end(), number,
    [](const Lamp& each, vtkIdType wanted) { return each.Number < wanted; });
  if (lamp != this->Lamps.end() && lamp->Number == number)
  {
    const auto texels = this->Texels.begin() + (lamp - this->Lamps.begin()) * TexelFloats;
    this->Texels.erase(texels, texels + TexelFloats);
    this->Lamps.erase(lamp);
  }
}
