// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockBytes.h"

#include <algorithm>

namespace relievo
{
//------------------------------------------------------------------------------
double BytesOfBlocks(vtkIdType vertices, vtkIdType faces, const BlockSettings& settings,
  const BlockMeshSettings& mesh, int labelBytes)
{
  constexpr double Id = sizeof(vtkIdType);
  constexpr double Triple = 3. * sizeof(float);
  constexpr double Pair = 2. * sizeof(float);
  const auto count = static_cast<double>(vertices);
  const auto quads = static_cast<double>(faces);
  const double corners = 4. * quads;
  const double place = (settings.DoublePoints ? 2. : 1.) * Triple;
  const double normal = settings.Normals ? Triple : 0.;
  const double texture = mesh.TextureCoordinates ? Pair : 0.;
  const auto chosen = static_cast<double>(mesh.WeightedLabels.size());
  const double weights = mesh.Weights ? sizeof(float) * (chosen > 0. ? chosen : 8.) : 0.;
  const bool own = mesh.SplitMaterials || mesh.TextureCoordinates || mesh.Weights;
  const double points = mesh.TextureCoordinates ? corners : count;

  const double surface =
    count * (place + normal + (settings.KeepOffsets ? sizeof(BlockRule::Offset) : 0.)) +
    quads * sizeof(BlockFace);
  double around = 0.; // while points of their own are made
  double kept = 0.;
  if (own)
  {
    around = 3. * Id * count + Id * corners;
    around += mesh.TextureCoordinates ? count * (Id + normal) : 0.;
    kept = corners * (Id + texture) + points * (Id + normal) + count * weights;
  }
  const double cellsPerFace = mesh.Triangles ? 2. : 1.;
  const double ids = (mesh.Triangles ? 6. : 4.) + cellsPerFace;
  const double number =
    std::max(6. * quads + 1., points) < VTK_TYPE_INT32_MAX ? sizeof(vtkTypeInt32) : Id;
  double polygons =
    quads * (ids * number + cellsPerFace * labelBytes * (settings.Faces.BetweenLabels ? 2. : 1.));
  if (own || mesh.HasGhosts)
  {
    polygons += Id * corners + points * (Id + place + normal + texture + weights);
  }
  if (mesh.HasGhosts)
  {
    polygons += quads * (Id + cellsPerFace) + points * 2. * Id;
  }
  return surface + kept + std::max(around, polygons);
}
}
