// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinFrames.h
 * @brief Frames of a mesh moved by the vertex shader, beside those of that mesh without movement.
 */
#ifndef SkinFrames_h
#define SkinFrames_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

namespace relievoBench
{
/**
 * A wavy sheet with about so many points, with normals and triangles of equal size, without bones.
 */
vtkSmartPointer<vtkPolyData> MakeSheet(int points);

/**
 * Frame times in seconds, ascending: of the rigid mesh; moved by matrices; by dual quaternions. The
 * latter two alternate between two poses. All are drawn in turn, each in its own window.
 */
std::vector<std::vector<double>> TimeSkinnedFrames(
  vtkPolyData* mesh, vtkPolyData* pose, vtkPolyData* otherPose, int rounds);
}

#endif
