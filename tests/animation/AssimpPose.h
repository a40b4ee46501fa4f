// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AssimpPose.h
 * @brief The truth of animated models: straight from Assimp's structures, all weights, in double,
 * with rotations as powers of one rotation instead of quaternion formulas of ours.
 */
#ifndef AssimpPose_h
#define AssimpPose_h

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace relievoTest
{
/** The reader's request to Assimp, so that points have equal numbers. */
extern const unsigned int AssimpSteps;

/** Node to world at a time in ticks; a null animation is the tree at rest. */
glm::dmat4 WorldOf(const aiNode* node, const aiAnimation* animation, double ticks);

/**
 * The points of every mesh of every node, in the reader's order, moved by all their bones' blended
 * matrices.
 */
std::vector<std::vector<glm::dvec3>> PosedPoints(
  const aiScene* scene, const aiAnimation* animation, double ticks);

/** Most bones of any point. */
int MostBones(const aiScene* scene);
}

#endif
