// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells inside real meshes by parity against Embree, a vote of three rays from each cell's centre,
// and against the meshes' own volume.
#include "Check.h"
#include "EmbreeScene.h"
#include "Scenes.h"
#include "Session.h"
#include "TestCase.h"
#include "VoxelTruth.h"
#include "vtkRelievoVoxelShell.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testVoxelShellMeshes
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;

double VolumeOf(vtkPolyData* mesh)
{
  double sum = 0.;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    glm::dvec3 corners[3];
    mesh->GetPoint(ids->GetId(0), &corners[0][0]);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      mesh->GetPoint(ids->GetId(i - 1), &corners[1][0]);
      mesh->GetPoint(ids->GetId(i), &corners[2][0]);
      sum += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6.;
    }
  }
  return std::abs(sum);
}

void TestMesh(const std::string& name, int resolution, bool closed)
{
  const vtkSmartPointer<vtkPolyData> mesh = LoadMesh(name);
  if (!mesh)
  {
    return;
  }
  EmbreeScene scene;
  scene.AddActor(mesh);
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->SetResolution(resolution);
  filter->Update();
  std::printf("%s, %lld triangles: %s\n", name.c_str(), scene.NumberOfTriangles(),
    filter->GetReport().c_str());
  vtkImageData* image = filter->GetOutput();
  auto* mask = vtkUnsignedCharArray::SafeDownCast(image->GetCellData()->GetArray("mask"));
  const int* points = image->GetDimensions();
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const int cells[3] = { points[0] - 1, points[1] - 1, points[2] - 1 };
  const std::vector<unsigned char> truth =
    CellsInside([&scene](const glm::dvec3& place) { return IsInsideByVote(scene, place); }, cells,
      origin, glm::dvec3(spacing[0], spacing[1], spacing[2]));
  const auto inside = std::count(truth.begin(), truth.end(), 1);
  int mismatches = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    mismatches += truth[i] != mask->GetValue(static_cast<vtkIdType>(i)) ? 1 : 0;
  }
  RELIEVO_CHECK(inside > 1000);
  RELIEVO_CHECK_AT_MOST(static_cast<double>(mismatches) / static_cast<double>(inside), 1e-3,
    name + ": cells other than Embree's vote, share of those inside");
  RELIEVO_CHECK_THAT(filter->IsClosed() == closed, name + ": closed or not");
  if (closed)
  {
    RELIEVO_CHECK(filter->GetNumberOfOpenColumns(2) == 0);
    filter->SetResolution(160);
    filter->Update();
    image = filter->GetOutput();
    const double cellVolume = std::pow(image->GetSpacing()[0], 3.);
    RELIEVO_CHECK_NEAR(
      static_cast<double>(filter->GetNumberOfCellsInside()) * cellVolume / VolumeOf(mesh), 1., 1e-3,
      name + ": volume");
  }
}
}

RELIEVO_TEST_CASE(testVoxelShellMeshes)
{
  relievoTest::Session session;
  TestMesh("bunny", 40, true);
  TestMesh("armadillo", 40, true);
  TestMesh("elephant", 40, true);
  return session.Result();
}
}
