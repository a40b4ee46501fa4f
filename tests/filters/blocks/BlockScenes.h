// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockScenes.h
 * @brief Images of labels, and checks of their surfaces.
 */
#ifndef relievoTestBlockScenes_h
#define relievoTestBlockScenes_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <functional>
#include <map>
#include <vector>

class vtkIdList;
class vtkImageData;
class vtkPolyData;
class vtkRelievoSmoothBlocks;

namespace relievoTest
{
using LabelOf = std::function<vtkTypeInt64(int, int, int)>;

/** Labels on cells, or on points, of an image with so many of them in each direction. */
vtkSmartPointer<vtkImageData> MakeBlocks(
  const std::array<int, 3>& size, const LabelOf& label, int type = VTK_INT, bool onPoints = false);

/** A ball around a place, in blocks. */
LabelOf BallOf(double radius, const std::array<double, 3>& center);

/** Any labels from 0 to count - 1, the same for the same seed. */
LabelOf AnyOf(unsigned int seed, int count);

/** The filter's result for the image; fails the test on an error. */
vtkPolyData* Run(vtkRelievoSmoothBlocks* filter, vtkImageData* image);

using Place = std::array<double, 3>;
using Edge = std::array<Place, 2>; // the smaller one first

/** Calls `each` with the number of each triangle, the ids of its corners, and their places. */
void ForEachTriangle(
  vtkPolyData* surface, const std::function<void(vtkIdType, vtkIdList*, const Place*)>& each);

/** The normal of a triangle, twice as long as its area is large. */
void AreaOf(const Place* corners, double area[3]);

/** How many polygons use an edge, by the places of its ends. */
std::map<Edge, int> EdgeUses(vtkPolyData* surface);

/**
 * Edges between two faces of blocks whose use differs from twice and that output 1 does not list,
 * or lists with another count. Diagonals of faces are used twice by construction.
 */
int UnlistedEdges(vtkPolyData* surface, vtkPolyData* seams);

/** The smallest area of a triangle. */
double SmallestArea(vtkPolyData* surface);

/** The volume inside, from the triangles' orientation. */
double VolumeOf(vtkPolyData* surface);

/** The number of points minus edges plus polygons, of points at different places. */
vtkIdType EulerNumber(vtkPolyData* surface);
}

#endif
