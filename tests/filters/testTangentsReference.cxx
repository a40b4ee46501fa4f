// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tangents of three awkward meshes against those of the original MikkTSpace code, corner by corner:
// reference/tangents.txt, made by reference/makeTangents.py.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoTangents.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace testTangentsReference
{
namespace
{
using namespace relievoTest;

struct Reference
{
  vtkNew<vtkPolyData> Mesh;
  std::vector<glm::dvec4> Tangents; // three a triangle
};

// The next mesh of the file; false at its end.
bool Read(std::istream& file, std::string& name, Reference& reference)
{
  int numberOfPoints = 0;
  int numberOfTriangles = 0;
  if (!(file >> name >> numberOfPoints >> numberOfTriangles))
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkFloatArray> texture;
  vtkNew<vtkCellArray> polys;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  texture->SetNumberOfComponents(2);
  texture->SetName("TCoords");
  for (int i = 0; i < numberOfPoints; ++i)
  {
    float p[8];
    for (float& number : p)
    {
      file >> number;
    }
    points->InsertNextPoint(p);
    normals->InsertNextTuple(p + 3);
    texture->InsertNextTuple(p + 6);
  }
  for (int i = 0; i < numberOfTriangles; ++i)
  {
    vtkIdType corners[3];
    for (vtkIdType& corner : corners)
    {
      file >> corner;
    }
    polys->InsertNextCell(3, corners);
    for (int c = 0; c < 3; ++c)
    {
      glm::dvec4 t;
      file >> t.x >> t.y >> t.z >> t.w;
      reference.Tangents.push_back(t);
    }
  }
  RELIEVO_CHECK(file.good());
  reference.Mesh->SetPoints(points);
  reference.Mesh->SetPolys(polys);
  reference.Mesh->GetPointData()->SetNormals(normals);
  reference.Mesh->GetPointData()->SetTCoords(texture);
  return true;
}

void Compare(const std::string& name, const Reference& reference)
{
  vtkNew<vtkRelievoTangents> filter;
  filter->SetInputData(reference.Mesh);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* tangents = output->GetPointData()->GetArray("tangent");
  const auto count = static_cast<vtkIdType>(reference.Tangents.size());
  if (!RELIEVO_CHECK(tangents && output->GetNumberOfPolys() * 3 == count))
  {
    return;
  }
  double worst = 0.;
  int handedness = 0;
  int none = 0;
  for (vtkIdType c = 0; c < count; ++c)
  {
    double t[4];
    vtkNew<vtkIdList> corners;
    output->GetPolys()->GetCellAtId(c / 3, corners);
    tangents->GetTuple(corners->GetId(static_cast<int>(c % 3)), t);
    const glm::dvec4& expected = reference.Tangents[c];
    const glm::dvec3 a(t[0], t[1], t[2]);
    const glm::dvec3 b(expected);
    if (b == glm::dvec3(1., 0., 0.))
    {
      ++none; // left by the original where it found nothing
      continue;
    }
    handedness += t[3] == expected.w ? 0 : 1;
    const double degrees =
      57.295779513082320877 * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    worst = std::max(worst, degrees);
  }
  std::cout << name << ": " << count << " corners, " << none << " left out, "
            << filter->GetNumberOfAddedPoints() << " points added, "
            << filter->GetNumberOfDegenerateTriangles() << " without texture area\n";
  RELIEVO_CHECK(none * 20 < count);
  RELIEVO_CHECK_AT_MOST(worst, 0.01, name + ": degrees from MikkTSpace's tangents");
  RELIEVO_CHECK_AT_MOST(handedness, 0, name + ": corners of the other handedness");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testTangentsReference)
{
  Session session;
  std::ifstream file(RELIEVO_TANGENTS);
  std::string line;
  std::string meshes;
  while (std::getline(file, line))
  {
    meshes += line.empty() || line[0] == '#' ? std::string() : line + "\n";
  }
  std::istringstream text(meshes);
  int count = 0;
  std::string name;
  for (;; ++count)
  {
    Reference reference;
    if (!Read(text, name, reference))
    {
      break;
    }
    Compare(name, reference);
  }
  RELIEVO_CHECK(count == 3);
  return session.Result();
}
}
