// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowView.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkRelievoMapAxis::Warp(double focus, double ratio, int size)
{
  *this = vtkRelievoMapAxis();
  // Fewer pieces would gain less than they cost.
  if (!(ratio > 1.5))
  {
    return;
  }
  this->Focus = focus;
  this->Ratio = ratio;
  this->Pieces = ratio > 6.0 ? 4 : ratio > 2.5 ? 3 : 2;
  const double reach = std::max(focus, 1.0 - focus);
  // The density of the logistic function is proportional to 1 / cosh^2.
  const double k = 2.0 * std::acosh(std::sqrt(ratio)) / reach;
  auto logistic = [&](double x) { return 1.0 / (1.0 + std::exp(-k * (x - focus))); };
  const double low = logistic(0.0);
  const double high = logistic(1.0);
  for (int i = 1; i < this->Pieces; ++i)
  {
    const double to =
      std::round(static_cast<double>(i) * size / this->Pieces) / static_cast<double>(size);
    const double value = low + to * (high - low);
    this->To[i] = to;
    this->From[i] = focus - std::log(1.0 / value - 1.0) / k;
  }
  this->From[this->Pieces] = this->To[this->Pieces] = 1.0;
}

//------------------------------------------------------------------------------
vtkRelievoShadowView vtkRelievoShadowView::GetPiece(int u, int v, int size, int region[4]) const
{
  vtkRelievoShadowView piece = *this;
  glm::dmat4 crop(1.0);
  const vtkRelievoMapAxis* axes[2] = { &this->U, &this->V };
  const int places[2] = { u, v };
  for (int k = 0; k < 2; ++k)
  {
    const vtkRelievoMapAxis& axis = *axes[k];
    const int i = places[k];
    const double from = 2.0 * axis.From[i] - 1.0;
    const double to = 2.0 * axis.From[i + 1] - 1.0;
    crop[k][k] = 2.0 / (to - from);
    crop[3][k] = -(to + from) / (to - from);
    region[k] = static_cast<int>(std::lround(axis.To[i] * size));
    region[2 + k] = static_cast<int>(std::lround(axis.To[i + 1] * size)) - region[k];
  }
  piece.ViewToNDC = crop * this->ViewToNDC;
  return piece;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowView::IsSame(const vtkRelievoShadowView& other) const
{
  auto same = [](const vtkRelievoMapAxis& a, const vtkRelievoMapAxis& b) {
    return a.Pieces == b.Pieces && a.Focus == b.Focus && a.Ratio == b.Ratio;
  };
  // The matrices' sources: drawing rewrites WorldToView with other rounding.
  return this->Position == other.Position && this->Forward == other.Forward &&
    this->Up == other.Up && this->Parallel == other.Parallel && this->Near == other.Near &&
    this->Far == other.Far && this->NearCut == other.NearCut && this->Side == other.Side &&
    this->ViewToNDC == other.ViewToNDC && this->Texel == other.Texel && same(this->U, other.U) &&
    same(this->V, other.V);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowView::Sees(const vtkRelievoBox& box) const
{
  // Not if all corners are beyond one side of the map, or beyond its far plane.
  const glm::dmat4 worldToNDC = this->ViewToNDC * this->WorldToView;
  int outside = 31;
  for (const glm::dvec3& corner : box.GetCorners())
  {
    const glm::dvec4 p = worldToNDC * glm::dvec4(corner, 1.0);
    outside &= (p.x < -p.w ? 1 : 0) | (p.x > p.w ? 2 : 0) | (p.y < -p.w ? 4 : 0) |
      (p.y > p.w ? 8 : 0) | ((this->Parallel ? p.z > p.w : p.w <= 0.0) ? 16 : 0);
  }
  return outside == 0;
}
