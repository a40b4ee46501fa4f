// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinPeer.h
 * @brief VTK's own reader of glTF, which skins on the CPU, as the peer of vtkRelievoSkin.
 */
#ifndef SkinPeer_h
#define SkinPeer_h

#include <cstdint>
#include <string>
#include <vector>

namespace relievoBench
{
struct SkinnedPoints
{
  std::vector<float> Points, Normals; ///< three of each
  std::vector<std::uint16_t> Joints;  ///< four of each
  std::vector<float> Weights;         ///< four of each
  std::vector<float> Turns;           ///< quaternions x, y, z, w of the bones after a second
  int Bones;
};

/** A .glb of these points, whose bones turn from rest to their turns within a second. */
void WriteSkinned(const std::string& path, const SkinnedPoints& mesh);

/** Milliseconds of each of so many steps of its time; none if VTK sees no animation. */
std::vector<double> TimeVtkReader(const std::string& path, int rounds);
}

#endif
