// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockBytes.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <set>

namespace relievo
{
namespace
{
// How many labels can have weights: all labels, up to the limit.
double CountWeights(const BlockMeshSettings& mesh, vtkDataArray* labels)
{
  if (!mesh.WeightedLabels.empty())
  {
    return static_cast<double>(mesh.WeightedLabels.size());
  }
  std::set<vtkTypeInt64> found;
  const auto count = [&found](const auto* values, vtkIdType size) {
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (i == 0 || values[i] != values[i - 1])
      {
        found.insert(static_cast<vtkTypeInt64>(values[i]));
        if (static_cast<vtkIdType>(found.size()) >= BlockMeshSettings::MostWeights)
        {
          return;
        }
      }
    }
  };
  switch (labels->GetDataType())
  {
    vtkTemplateMacro(
      count(static_cast<VTK_TT*>(labels->GetVoidPointer(0)), labels->GetNumberOfTuples()));
  }
  return static_cast<double>(found.size());
}
}

//------------------------------------------------------------------------------
double BytesOfBlocks(vtkIdType vertices, vtkIdType faces, const BlockSettings& settings,
  const BlockMeshSettings& mesh, vtkDataArray* labels)
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
  const double weights = mesh.Weights ? sizeof(float) * CountWeights(mesh, labels) : 0.;
  const int labelBytes = labels->GetDataTypeSize();
  const bool own = mesh.SplitMaterials || mesh.TextureCoordinates || mesh.Weights;
  const double points = mesh.TextureCoordinates ? corners : count;

  const double surface =
    count * (place + normal + (settings.KeepOffsets ? sizeof(BlockRule::Offset) : 0.)) +
    quads * sizeof(BlockFace);
  double around = 0.; // while faces get points of their own
  double kept = 0.;
  if (own)
  {
    around = 3. * Id * count + Id * corners;
    around += mesh.TextureCoordinates ? count * (Id + normal) : 0.;
    // The labels on one or both sides of each face, and a sorted list of all of them.
    around += mesh.Weights ? quads * Id * (settings.Faces.BetweenLabels ? 4. : 2.) : 0.;
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

//------------------------------------------------------------------------------
double BytesOfSeams(vtkIdType seams, const BlockSettings& settings)
{
  const double place = settings.DoublePoints ? 3. * sizeof(double) : 3. * sizeof(float);
  // Each slab's list has room to grow while the seams are joined into one list.
  const double listed = 3. * sizeof(BlockSeam);
  const double line = 2. * place + 3. * sizeof(vtkIdType) + sizeof(int);
  return static_cast<double>(seams) * (listed + line);
}
}
