// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfScene.h
 * @brief A glTF file made by code: one triangle whose node moves by given keys.
 */
#ifndef GltfScene_h
#define GltfScene_h

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

/** Whether a path is that of the binary form. */
bool IsGlb(const std::string& path);

/** The part of a buffer after its length: nothing in binary files, otherwise the bytes as text. */
std::string WriteGltfUri(const std::string& path, const std::string& bytes);

/** The JSON, and in binary the bytes of its first buffer, of a multiple of four. */
void WriteGltfFile(const std::string& path, std::string text, const std::string& bytes);

/** In base 64. */
std::string EncodeBytes(const std::string& bytes);
}

#endif
