// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MadeMeshes.h
 * @brief Meshes made by code: things by lot, and what shadows go wrong on, where edges lie densely.
 *
 * About 4 wide, over the ground of the reference scenes, which is at y = 0.
 */
#ifndef relievoTestMadeMeshes_h
#define relievoTestMadeMeshes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <random>

namespace relievoTest
{
/** Numbers by lot, equal on every machine, which the standard's distributions are not. */
class Lots
{
public:
  explicit Lots(unsigned int seed)
    : Random(seed)
  {
  }
  double Between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Random()) / 4294967296.;
  }

private:
  std::mt19937 Random;
};

/** Five boxes and cylinders, askew. */
vtkSmartPointer<vtkPolyData> MakeThings(Lots& lots);

/** 40 upright fins of length 2 whose tops are about a pixel of a picture of 500 wide, or less. */
vtkSmartPointer<vtkPolyData> MakeFins();

/** Mountains of 32 768 triangles, by midpoint displacement: folds in all directions. */
vtkSmartPointer<vtkPolyData> MakeFolds();

/** 1500 arrows along a vortex. */
vtkSmartPointer<vtkPolyData> MakeArrows();

/** A tree: 1093 tubes, each but the last with three thinner ones at its end. */
vtkSmartPointer<vtkPolyData> MakeTree();
}

#endif
