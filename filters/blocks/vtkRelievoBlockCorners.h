// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockCorners.h
 * @brief Separate points for faces that cannot share a vertex, because of normals, texture
 * coordinates or weights of materials.
 */
#ifndef vtkRelievoBlockCorners_h
#define vtkRelievoBlockCorners_h

#include "vtkRelievoBlockMesh.h"

#include <string>

namespace relievo
{
/** Points that replace the vertices: four per face, in the order of its corners. */
struct BlockCorners
{
  std::vector<vtkIdType> Points;   // point of each face corner
  std::vector<vtkIdType> Vertices; // vertex of each point
  std::vector<std::array<float, 3>> Normals;
  std::vector<std::array<float, 2>> Texture;
  std::vector<std::string> WeightNames;
  std::vector<float> Weights; // per vertex, one for each name
  double TileSize = 0.;       // needed by the largest face; 0 without an atlas
};

BlockCorners MakeBlockCorners(const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);

/**
 * Gives faces separate points where their normals cancel out. The surface then has more points than
 * vertices; leave room for 12 points per vertex below 2^32.
 */
void SplitNullNormals(BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);

/** The texture of a face: coordinates of its corners, in the order of its points. */
struct FaceTexture
{
  std::array<std::array<float, 2>, 4> Places;
  double TileSize = 0.; // needed by the face; 0 without an atlas
};

FaceTexture TextureOf(const BlockFace& face, const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);
}

#endif
