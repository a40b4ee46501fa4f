// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Names of the arrays by which the reader and the filter understand each other; users see them.
 */
#ifndef vtkRelievoSkinNames_h
#define vtkRelievoSkinNames_h

namespace relievo
{
/// Of a mesh's points: places in the mesh's list of bones, strongest first, -1 for none; their
/// weights, 0 there.
constexpr const char* JointsArray = "joints";
constexpr const char* WeightsArray = "weights";

/// Of a mesh's field data, a tuple for each bone: the skeleton's point; the matrix from the mesh's
/// rest points to the bone, by rows.
constexpr const char* BoneNodeArray = "bone_node";
constexpr const char* BoneOffsetArray = "bone_offset";

/// Of the skeleton's points: the matrix from the node to the world, by rows; the same at the keys
/// before and after.
constexpr const char* PoseArray = "pose";
constexpr const char* PoseBeforeArray = "pose_before";
constexpr const char* PoseAfterArray = "pose_after";

/// Of the skeleton's field data: where between these keys the time lies, 0 to 1.
constexpr const char* KeyShareArray = "key_share";

/// Of a mesh's points, to look inside: the node of the strongest bone; the weight of a chosen one.
constexpr const char* FirstBoneArray = "first_bone";
constexpr const char* BoneWeightArray = "bone_weight";
}

#endif
