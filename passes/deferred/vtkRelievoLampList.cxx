// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampList.h"

#include "vtkRelievoLamps.h"
#include "vtkRelievoThreads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

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
