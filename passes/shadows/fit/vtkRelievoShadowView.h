// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A view that a light's map is drawn from, and how the map spends its texels on it.
#ifndef vtkRelievoShadowView_h
#define vtkRelievoShadowView_h

#include "vtkRelievoShadowRegion.h"

// How one axis of a map spends its texels: straight pieces from a place of the fitted rectangle to
// a place of the map, both in [0, 1]. One piece from 0 to 1: evenly.
struct vtkRelievoMapAxis
{
  static constexpr int MostPieces = 4;
  int Pieces = 1;
  double From[MostPieces + 1] = { 0.0, 1.0 };
  double To[MostPieces + 1] = { 0.0, 1.0 };

  // Along the axis, where a density in the shape of the logistic function's is highest at `focus`
  // and `ratio` times lower at the end that is farther off. Ends of pieces are whole texels.
  void Warp(double focus, double ratio, int size);

  double Focus = 0.5;
  double Ratio = 1.0;
};

struct vtkRelievoShadowView
{
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Forward{ 0.0 }; // unit
  glm::dvec3 Up{ 0.0 };      // unit, square to Forward
  bool Parallel = true;
  double Near = 0.0;
  double Far = 1.0;
  bool NearCut = false;          // casters were drawn onto the near plane, before the region's own
  int Side = -1;                 // of a cube; -1: turned freely
  glm::dmat4 WorldToView{ 1.0 }; // looks along -z
  glm::dmat4 ViewToNDC{ 1.0 };
  double Texel = 0.0; // map depth of a texel's width, where w = 1
  double Width = 0.0; // of the map: world units, or tangents of a perspective view
  double Height = 0.0;
  vtkRelievoMapAxis U;
  vtkRelievoMapAxis V;

  // Whether a map of one is a map of the other.
  bool IsSame(const vtkRelievoShadowView& other) const;

  // This view, cut to one piece of the map; `region`: the piece's place in the map, x y width
  // height in texels.
  vtkRelievoShadowView GetPiece(int u, int v, int size, int region[4]) const;

  // Whether something in the box may cast into the map.
  bool Sees(const vtkRelievoBox& box) const;
};

#endif
