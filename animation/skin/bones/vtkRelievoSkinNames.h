// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Names of the arrays exchanged between the reader and the filter; users see them. */
#ifndef vtkRelievoSkinNames_h
#define vtkRelievoSkinNames_h

namespace relievo
{
/// Point arrays of a mesh: indices in the mesh's list of bones, strongest first, -1 for none; and
/// their weights, 0 there.
constexpr const char* JointsArray = "joints";
constexpr const char* WeightsArray = "weights";

/// Field data of a mesh, a tuple for each bone: the index in the skeleton; and the matrix from the
/// mesh's rest points to the bone, by rows.
constexpr const char* BoneNodeArray = "bone_node";
constexpr const char* BoneOffsetArray = "bone_offset";

/// Point arrays of the skeleton: the matrix from the node to the world, by rows; and those of the
/// keys before and after.
constexpr const char* PoseArray = "pose";
constexpr const char* PoseBeforeArray = "pose_before";
constexpr const char* PoseAfterArray = "pose_after";

/// Field data of the skeleton: the fraction of the time between these keys, 0 to 1.
constexpr const char* KeyShareArray = "key_share";

/// Point arrays of a mesh for inspection: the node of the strongest bone; the weight of a chosen
/// one.
constexpr const char* FirstBoneArray = "first_bone";
constexpr const char* BoneWeightArray = "bone_weight";
}

#endif
