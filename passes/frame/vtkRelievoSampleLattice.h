// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The places of samples within each pixel as a lattice that goes on from pixel to pixel: those of a
// finer raster, turned against the pixels, so that one drawing has all samples of a picture.
//
// The steps to the pixel on the right and to the one above are whole cells of the raster, so that
// every pixel has its samples at equal places (S. Dammertz, A. Keller, Image synthesis by rank-1
// lattices, 2008). The places differ in x and in y, and are far apart.
#ifndef vtkRelievoSampleLattice_h
#define vtkRelievoSampleLattice_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

class VTKRELIEVOFRAME_EXPORT vtkRelievoSampleLattice
{
public:
  explicit vtkRelievoSampleLattice(int samples);

  // The number of samples that err no more along edges and in penumbras than so many drawn one by
  // one: two thirds more, since edges may be parallel to rows of a lattice, and borders of shadows
  // to rows of its parts of a light. A prime, so that no row is sparse.
  static int GetNumberInPlaceOf(int samples);

  int GetNumberOfSamples() const { return static_cast<int>(this->Cells.size()); }

  // Cells of the raster from a pixel to the one on its right, and to the one above.
  const glm::ivec2& GetRight() const { return this->Right; }
  const glm::ivec2& GetUp() const { return this->Up; }

  // The cells of the samples of the pixel at the origin, the one next to its centre first.
  const std::vector<glm::ivec2>& GetCells() const { return this->Cells; }

  // Which sample of its pixel a cell of the raster has, from 0 on: step.x * x + step.y * y, modulo
  // their number.
  glm::ivec2 GetNumberStep() const;

  // Where a cell's sample is, in pixels.
  glm::dvec2 GetPlace(const glm::ivec2& cell) const;

  // Cells of a raster that has all samples of so many pixels; and the cell, counted from the
  // raster's lowest left one, that the origin's cells are counted from.
  glm::ivec2 GetSize(const glm::ivec2& pixels) const;
  glm::ivec2 GetOrigin(const glm::ivec2& pixels) const;

  // From the NDC of a viewport of this size to the NDC of the raster of a part of it, x, y, width
  // and height in pixels: for clip coordinates.
  glm::dmat4 GetToRaster(const glm::ivec2& viewport, const int part[4]) const;

private:
  void FindCells();

  glm::ivec2 Right{ 1, 0 };
  glm::ivec2 Up{ 0, 1 };
  glm::dvec2 Shift{ 0.0 }; // of places, in pixels: the mean of all is the pixel's centre
  std::vector<glm::ivec2> Cells;
};

#endif
