// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The skeleton as data: a point for each node of the model, lines between joints.
 */
#ifndef vtkRelievoSkeleton_h
#define vtkRelievoSkeleton_h

#include "vtkRelievoModel.h"

namespace relievo
{
/// Node to world for every node: at the time, and at the whole keys around it.
struct SkeletonPose
{
  std::vector<glm::dmat4> Now;
  std::vector<glm::dmat4> Before;
  std::vector<glm::dmat4> After;
  double Share = 0.;
};

/// Points at the nodes, with `pose`, `pose_before`, `pose_after`, `parent`, `is_bone` and `name`,
/// and a line from each bone or moved node to its parent if that is also one. `axes`: length of
/// lines along the axes of bones and moved nodes, 0 for none; cells then have `axis` (0 between
/// joints, 1 to 3 along x, y, z) and its colours `axis_color`, and the ends of the axes follow the
/// nodes' points.
void MakeSkeleton(const Model& model, const SkeletonPose& pose, double axes, vtkPolyData* output);

/// A suitable length of axes: a share of the diagonal of bones and meshes at rest.
double GetAxisLength(const Model& model);
}

#endif
