// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MadeMeshes.h
 * @brief Generated meshes: random objects, and meshes with dense edges, which are difficult for
 * shadows.
 *
 * About 4 wide, on the ground of the reference scenes at y = 0.
 */
#ifndef relievoTestMadeMeshes_h
#define relievoTestMadeMeshes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <random>

namespace relievoTest
{
/** Random numbers, equal on every machine, unlike those of the standard's distributions. */
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

/** Five boxes and cylinders at random angles. */
vtkSmartPointer<vtkPolyData> MakeThings(Lots& lots);

/**
 * 40 upright fins of length 2 whose tops are at most about a pixel wide in a picture of 500 pixels.
 */
vtkSmartPointer<vtkPolyData> MakeFins();

/** Mountains of 32 768 triangles, by midpoint displacement: folds in all directions. */
vtkSmartPointer<vtkPolyData> MakeFolds();

/** 1500 arrows along a vortex. */
vtkSmartPointer<vtkPolyData> MakeArrows();

/** A tree: 1093 tubes, each but the last with three thinner ones at its end. */
vtkSmartPointer<vtkPolyData> MakeTree();
}

#endif
