// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfScene.h
 * @brief A glTF file made by code: one triangle whose node moves by given keys.
 */
#ifndef GltfScene_h
#define GltfScene_h

#include <cstddef>
#include <string>
#include <vector>

namespace relievoTest
{
/** One track: `path` is translation, rotation or scale, `mode` STEP, LINEAR or CUBICSPLINE. */
struct GltfTrack
{
  std::string Path;
  std::string Mode;
  std::vector<float> Times;
  std::vector<float> Values; ///< CUBICSPLINE: slope before, value, slope after, for each key
};

/**
 * Writes the triangle (1, 0, 0), (2, 0, 0), (2, 0, 1), on a node "arm", or one without a name, in
 * an animation "move" of these tracks. A path that ends in .glb is written in binary.
 */
void WriteGltf(const std::string& path, const std::vector<GltfTrack>& tracks, bool named = true);

/** Four bytes, as .glb has its lengths. */
void AppendNumber(std::string& to, std::size_t value);

/** In base 64. */
std::string EncodeBytes(const std::string& bytes);
}

#endif
