// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockCorners.h
 * @brief Points of their own for faces that cannot share a vertex: normals, texture coordinates,
 * weights of materials.
 */
#ifndef vtkRelievoBlockCorners_h
#define vtkRelievoBlockCorners_h

#include "vtkRelievoBlockMesh.h"

#include <string>

namespace relievo
{
/** Points that replace the vertices, four for each face in the order of its points. */
struct BlockCorners
{
  std::vector<vtkIdType> Points;   // of the faces
  std::vector<vtkIdType> Vertices; // of the points
  std::vector<std::array<float, 3>> Normals;
  std::vector<std::array<float, 2>> Texture;
  std::vector<std::string> WeightNames;
  std::vector<float> Weights; // as many a vertex as there are names
  double TileSize = 0.;       // that the largest face needs; 0 without an atlas
};

BlockCorners MakeBlockCorners(const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);

/**
 * Gives faces points of their own where their normals cancel out. The surface then has more points
 * than vertices; room for 12 a vertex must be left below 2^32.
 */
void SplitNullNormals(BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);

/** The texture of a face: coordinates of its corners, in the order of its points. */
struct FaceTexture
{
  std::array<std::array<float, 2>, 4> Places;
  double TileSize = 0.; // that the face needs; 0 without an atlas
};

FaceTexture TextureOf(const BlockFace& face, const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh);
}

#endif
