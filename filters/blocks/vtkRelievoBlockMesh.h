// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockMesh.h
 * @brief Makes polygons with their arrays from the surface of blocks.
 */
#ifndef vtkRelievoBlockMesh_h
#define vtkRelievoBlockMesh_h

#include "vtkRelievoBlockSurface.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace relievo
{
struct BlockMeshSettings
{
  static constexpr vtkIdType MostWeights = 64;

  bool Triangles = true;
  bool SplitMaterials = false; // normals merge within a material
  bool TextureCoordinates = false;
  double TileSize = 1.; // world units
  int AtlasColumns = 0; // 0: textures repeat
  int AtlasRows = 0;
  bool Weights = false;
  std::vector<vtkTypeInt64> WeightedLabels; // empty: all
  // The blocks, numbered as in BlockBox, whose faces are included; faces outside Owned are ghosts.
  std::array<int, 6> Included = {};
  std::array<int, 6> Owned = {};
  bool HasGhosts = false; // some faces must be dropped or marked
};

struct BlockMeshReport
{
  // The number of labels that need weights; above MostWeights there are no weights.
  vtkIdType WeightedLabels = 0;
  // The atlas tile that the largest face needs, in world units; 0 without an atlas.
  double TileSize = 0.;
};

BlockMeshReport MakeBlockMesh(BlockSurface& surface, const BlockLabels& labels, vtkDataArray* array,
  const BlockSettings& settings, const BlockMeshSettings& mesh, vtkPolyData* output);

/** Makes lines of the seams whose lower end belongs to this piece. */
void MakeBlockSeams(const BlockSurface& surface, const std::array<int, 6>& owned,
  const std::array<int, 3>& size, vtkPolyData* output);
}

#endif
