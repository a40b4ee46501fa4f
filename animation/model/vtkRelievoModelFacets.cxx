// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelFacets.h"

#include "vtkRelievoSkinNames.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <vector>

namespace relievo
{
//------------------------------------------------------------------------------
void GiveFaceNormals(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
  normals->Fill(0.);
  vtkCellArray* polygons = mesh->GetPolys();
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, corners);
    glm::dvec3 at[3];
    for (int j = 0; j < 3; ++j)
    {
      mesh->GetPoint(corners->GetId(j), &at[j][0]);
    }
    const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
    const double length = glm::length(across);
    const glm::dvec3 n = length > 0. ? across / length : glm::dvec3(0., 0., 1.);
    for (vtkIdType j = 0; j < corners->GetNumberOfIds(); ++j)
    {
      normals->SetTuple3(corners->GetId(j), n.x, n.y, n.z);
    }
  }
  mesh->GetPointData()->SetNormals(normals);
}

//------------------------------------------------------------------------------
void TurnFaces(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> turned;
  vtkCellArray* polygons = mesh->GetPolys();
  turned->AllocateExact(polygons->GetNumberOfCells(), polygons->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> corners;
  std::vector<vtkIdType> others;
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, corners);
    const vtkIdType count = corners->GetNumberOfIds();
    others.clear();
    for (vtkIdType j = 0; j < count; ++j)
    {
      others.push_back(corners->GetId((count - j) % count));
    }
    turned->InsertNextCell(count, others.data());
  }
  mesh->SetPolys(turned);
}

//------------------------------------------------------------------------------
bool IsMirroredBy(const ModelMesh& mesh, const std::vector<glm::dmat4>& worlds)
{
  vtkDataArray* nodes = mesh.Data->GetFieldData()->GetArray(BoneNodeArray);
  vtkDataArray* offsets = mesh.Data->GetFieldData()->GetArray(BoneOffsetArray);
  vtkIdType mirrored = 0;
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    glm::dmat4 offset;
    for (int j = 0; j < 16; ++j)
    {
      offset[j % 4][j / 4] = offsets->GetComponent(i, j);
    }
    const auto node = static_cast<std::size_t>(nodes->GetComponent(i, 0));
    mirrored += glm::determinant(glm::dmat3(worlds[node] * offset)) < 0. ? 1 : 0;
  }
  return 2 * mirrored > nodes->GetNumberOfTuples();
}
}
