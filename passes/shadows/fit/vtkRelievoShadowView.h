// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A view for a light's map, and the distribution of the map's texels.
#ifndef vtkRelievoShadowView_h
#define vtkRelievoShadowView_h

#include "vtkRelievoShadowRegion.h"

// Texel distribution along one axis of a map: linear pieces from places of the fitted rectangle to
// places of the map, both in [0, 1]. A single piece from 0 to 1: even.
struct vtkRelievoMapAxis
{
  static constexpr int MostPieces = 4;
  int Pieces = 1;
  double From[MostPieces + 1] = { 0.0, 1.0 };
  double To[MostPieces + 1] = { 0.0, 1.0 };

  // Pieces along the axis for a density shaped like the logistic function's, highest at `focus` and
  // `ratio` times lower at the farther end. Pieces end at whole texels.
  void Warp(double focus, double ratio, int size);

  double Focus = 0.5;
  double Ratio = 1.0;
};

struct vtkRelievoShadowView
{
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Forward{ 0.0 }; // unit
  glm::dvec3 Up{ 0.0 };      // unit, perpendicular to Forward
  bool Parallel = true;
  double Near = 0.0;
  double Far = 1.0;
  bool NearCut = false;          // casters in front of the region were drawn onto the near plane
  int Side = -1;                 // of a cube; -1: any orientation
  glm::dmat4 WorldToView{ 1.0 }; // looks along -z
  glm::dmat4 ViewToNDC{ 1.0 };
  double Texel = 0.0; // map depth of a texel's width, where w = 1
  double Width = 0.0; // of the map: world units, or tangents in a perspective view
  double Height = 0.0;
  vtkRelievoMapAxis U;
  vtkRelievoMapAxis V;

  // Whether a map of one view is also a map of the other.
  bool IsSame(const vtkRelievoShadowView& other) const;

  // This view restricted to one piece of the map; `region`: the piece's place in the map, x y width
  // height in texels.
  vtkRelievoShadowView GetPiece(int u, int v, int size, int region[4]) const;

  // Whether casters in front of the near plane cast from it.
  bool Clamps() const { return this->NearCut || !this->Parallel; }

  // Whether a caster in the box may reach the map.
  bool Sees(const vtkRelievoBox& box) const;
};

#endif
