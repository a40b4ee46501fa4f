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

/// Points where the nodes are, with `pose`, `pose_before`, `pose_after`, `parent`, `is_bone` and
/// `name`; a line from each bone or moved node to its parent, when that is one too.
void MakeSkeleton(const Model& model, const SkeletonPose& pose, vtkPolyData* output);
}

#endif
