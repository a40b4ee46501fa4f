// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampList.h"

#include "vtkRelievoLampShadows.h"
#include "vtkRelievoLamps.h"
#include "vtkRelievoThreads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Lamps are taken in pieces, which threads share; what they find is joined in the pieces' order.
constexpr vtkIdType PieceSize = 1024;

struct Piece
{
  std::vector<vtkRelievoLampList::Lamp> Lamps;
  std::vector<float> Texels;
  bool White = true;
};

class Taker
{
public:
  Taker(const vtkRelievoView& view)
    : View(view)
    , Bounds(view.ViewToNDC)
  {
  }

  void Take(const double* row, float falloff, Piece& piece) const
  {
    const glm::dvec4 center = this->View.WorldToView * glm::dvec4(row[0], row[1], row[2], 1.0);
    vtkRelievoLampList::Lamp lamp;
    lamp.Sphere.Center = glm::dvec3(center);
    // What shaders find of a pixel's place and distance is rounded to float.
    lamp.Sphere.Radius = row[3] * (1.0 + 1e-5) + 1e-6 * glm::length(lamp.Sphere.Center);
    double rectangle[4];
    if (!this->Bounds.FindRectangle(lamp.Sphere, this->View.Near, this->View.Far, rectangle))
    {
      return;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      // In pixels; without the centre of one it lights nothing.
      const double half = 0.5 * this->View.Viewport[2 + axis];
      const double first = std::ceil((rectangle[axis] + 1.0) * half - 0.501);
      const double last = std::floor((rectangle[axis + 2] + 1.0) * half - 0.499);
      if (last < first)
      {
        return;
      }
    }
    std::copy_n(rectangle, 4, lamp.Rectangle);
    lamp.Row = row;
    piece.Lamps.push_back(lamp);
    for (int i = 0; i < 3; ++i)
    {
      piece.Texels.push_back(static_cast<float>(lamp.Sphere.Center[i]));
    }
    piece.Texels.push_back(static_cast<float>(row[3]));
    for (int i = 0; i < 3; ++i)
    {
      piece.Texels.push_back(static_cast<float>(row[4] * row[5 + i]));
    }
    piece.Texels.push_back(falloff);
    piece.White = piece.White && row[5] == row[6] && row[6] == row[7];
  }

private:
  const vtkRelievoView& View;
  vtkRelievoSphereBounds Bounds;
};

constexpr int TexelFloats = 8; // of a lamp

// A lamp that may cast.
struct Candidate
{
  std::size_t Place;
  bool Always;
  double Size;

  bool operator<(const Candidate& other) const
  {
    return this->Always != other.Always ? this->Always
      : this->Size != other.Size        ? this->Size > other.Size
                                        : this->Place < other.Place;
  }
};

double GetSize(const vtkRelievoLampList::Lamp& lamp)
{
  const double* row = lamp.Row;
  const float* r = lamp.Rectangle;
  return std::abs(row[4]) * std::max({ row[5], row[6], row[7] }) * (r[2] - r[0]) * (r[3] - r[1]);
}

// Up to so much more than the next lamp's size a shadow is weaker.
constexpr double Fade = 0.1;
}

//------------------------------------------------------------------------------
void vtkRelievoLampList::Take(const vtkRelievoView& view, const std::vector<vtkRelievoLamps*>& sets)
{
  this->Lamps.clear();
  this->Texels.clear();
  this->Attenuations.clear();
  this->NumberGiven = 0;
  this->White = true;
  const Taker taker(view);
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    const double* rows = sets[set]->GetSharedRows().data();
    const int width = sets[set]->GetRowWidth();
    const auto count = static_cast<vtkIdType>(sets[set]->GetSharedRows().size()) / width;
    // Linear is 0, inverse square 1; of VTK's, each set has its own: 2 and more.
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
            taker.Take(rows + i * width, static_cast<float>(falloff), pieces[p]);
          }
        }
      });
    for (const Piece& piece : pieces)
    {
      this->Lamps.insert(this->Lamps.end(), piece.Lamps.begin(), piece.Lamps.end());
      this->Texels.insert(this->Texels.end(), piece.Texels.begin(), piece.Texels.end());
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
  for (std::size_t i = 0; i < this->Lamps.size(); ++i)
  {
    const double casts = vtkRelievoLamps::GetCastsOf(this->Lamps[i].Row);
    if (casts > 0.0 || (casts < 0.0 && largest > 0))
    {
      candidates.push_back({ i, casts > 0.0, GetSize(this->Lamps[i]) });
      always += casts > 0.0 ? 1 : 0;
    }
  }
  const std::size_t most = std::min(
    { vtkRelievoCastingLamp::Most, always + largest, static_cast<int>(candidates.size()) });
  const std::size_t looked = std::min(most + 1, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + looked, candidates.end());
  std::vector<std::pair<std::size_t, double>> chosen;
  for (std::size_t i = 0; i < most; ++i)
  {
    const Candidate& lamp = candidates[i];
    const bool alone = looked == most || lamp.Always != candidates[most].Always;
    const double next = alone ? 0.0 : candidates[most].Size;
    const double strength = next > 0.0 ? std::min((lamp.Size / next - 1.0) / Fade, 1.0) : 1.0;
    if (strength > 0.0)
    {
      chosen.emplace_back(lamp.Place, strength);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<std::size_t> places;
  for (const auto& each : chosen)
  {
    places.push_back(each.first);
    strengths.push_back(each.second);
  }
  this->TakeOut(places, casting);
  return casting;
}

//------------------------------------------------------------------------------
// The lamps at these places, ascending.
void vtkRelievoLampList::TakeOut(const std::vector<std::size_t>& places, vtkRelievoLampList& others)
{
  for (const std::size_t place : places)
  {
    others.Lamps.push_back(this->Lamps[place]);
    const auto texels = this->Texels.begin() + static_cast<std::ptrdiff_t>(place * TexelFloats);
    others.Texels.insert(others.Texels.end(), texels, texels + TexelFloats);
  }
  for (auto place = places.rbegin(); place != places.rend(); ++place)
  {
    this->Lamps.erase(this->Lamps.begin() + static_cast<std::ptrdiff_t>(*place));
    const auto texels = this->Texels.begin() + static_cast<std::ptrdiff_t>(*place * TexelFloats);
    this->Texels.erase(texels, texels + TexelFloats);
  }
}
