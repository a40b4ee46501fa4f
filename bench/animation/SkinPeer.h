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
  std::vector<float> Turns;           ///< quaternions x, y, z, w of the bones after one second
  int Bones;
};

/** Writes a .glb of these points, whose bones turn from rest to `Turns` within a second. */
void WriteSkinned(const std::string& path, const SkinnedPoints& mesh);

/** Milliseconds for each of so many time steps; empty if VTK finds no animation. */
std::vector<double> TimeVtkReader(const std::string& path, int rounds);
}

#endif
