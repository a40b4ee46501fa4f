// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sample positions as a lattice that continues from pixel to pixel: the cells of a finer raster,
// rotated against the pixels, so that one drawing has all samples of a picture.
//
// The steps to the next pixel on the right and above are whole cells of the raster, so that every
// pixel has its samples at equal positions (S. Dammertz, A. Keller, Image synthesis by rank-1
// lattices, 2008). The positions differ in x and in y, and are far apart.
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

  // The number of samples with at most the error of `samples` samples drawn one by one, at edges
  // and in penumbras: two thirds more, since edges may be parallel to rows of a lattice, and
  // shadows' borders to rows of its parts of a light. A prime, so that no row is sparse.
  static int GetNumberInPlaceOf(int samples);

  int GetNumberOfSamples() const { return static_cast<int>(this->Cells.size()); }

  // Steps in cells of the raster from a pixel to the next one on the right, and above.
  const glm::ivec2& GetRight() const { return this->Right; }
  const glm::ivec2& GetUp() const { return this->Up; }

  // The cells of the samples in the pixel at the origin, the one nearest to its centre first.
  const std::vector<glm::ivec2>& GetCells() const { return this->Cells; }

  // The index of a cell's sample within its pixel, from 0 on, is step.x * x + step.y * y, modulo
  // the number of samples.
  glm::ivec2 GetNumberStep() const;

  // Position of a cell's sample, in pixels.
  glm::dvec2 GetPlace(const glm::ivec2& cell) const;

  // Size in cells of a raster with all samples of `pixels`; and its cell at the origin of
  // GetCells(), counted from the raster's lower left cell.
  glm::ivec2 GetSize(const glm::ivec2& pixels) const;
  glm::ivec2 GetOrigin(const glm::ivec2& pixels) const;

  // Transform of clip coordinates from the NDC of a viewport of this size to the NDC of the raster
  // of a part (x, y, width, height in pixels).
  glm::dmat4 GetToRaster(const glm::ivec2& viewport, const int part[4]) const;

private:
  void FindCells();

  glm::ivec2 Right{ 1, 0 };
  glm::ivec2 Up{ 0, 1 };
  glm::dvec2 Shift{ 0.0 }; // of positions, in pixels: centres their mean on the pixel
  std::vector<glm::ivec2> Cells;
};

#endif
