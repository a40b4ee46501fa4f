// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinFrames.h
 * @brief Frames of a mesh that the vertex shader moves, beside those of the same mesh held still.
 */
#ifndef SkinFrames_h
#define SkinFrames_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

namespace relievoBench
{
/** A wavy sheet of about so many points, with normals, triangles of equal size, and no bones. */
vtkSmartPointer<vtkPolyData> MakeSheet(int points);

/**
 * Seconds of frames, ascending: of the rigid mesh; moved by matrices; by dual quaternions. Each
 * frame of the latter two has another of the two poses. Drawn in turn, in a window each.
 */
std::vector<std::vector<double>> TimeSkinnedFrames(
  vtkPolyData* mesh, vtkPolyData* pose, vtkPolyData* otherPose, int rounds);
}

#endif
