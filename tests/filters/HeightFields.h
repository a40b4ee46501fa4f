// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HeightFields.h
 * @brief Heights from formulas with known slopes, and how far a normal map is from them.
 */
#ifndef relievoTestHeightFields_h
#define relievoTestHeightFields_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/vec2.hpp>

#include <functional>

namespace relievoTest
{
/** Height at (x, y), and its slope there in the unit of the spacing. */
struct HeightField
{
  std::function<double(double, double)> Height;
  std::function<glm::dvec2(double, double)> Slope;
};

/** Texels at origin + (i, j) * spacing. */
struct GridOf
{
  glm::ivec2 Size;
  glm::dvec2 Spacing;
  glm::dvec2 Origin;
};

/**
 * Three plane waves in different directions that repeat after `period` in x and y; the shortest has
 * at least `wave` per wave length; the slopes' root mean square is `slope`.
 */
HeightField Sines(double period, double wave, double slope);

/** The field's heights as scalars of a VTK type. */
vtkSmartPointer<vtkImageData> MakeHeights(const HeightField& field, const GridOf& grid, int type);

/** Angles to the field's normals, degrees; seam: the texels of the outermost rows and columns. */
struct NormalErrors
{
  double Mean;
  double Worst;
  double SeamMean;
};

/** The errors of a map of floats, or of codes of 8 or 16 bits decoded as in OpenGL. */
NormalErrors ErrorsOf(vtkImageData* normals, const HeightField& field, const GridOf& grid);
}

#endif
