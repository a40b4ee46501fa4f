// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkinScenes.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRelievoSkin.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
glm::dmat4 TurnAbout(const glm::dvec3& axis, double angle)
{
  const glm::dvec3 k = glm::normalize(axis);
  glm::dmat4 m(1.);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 e = glm::dmat3(1.)[i];
    m[i] = glm::dvec4(e * std::cos(angle) + glm::cross(k, e) * std::sin(angle) +
        k * (glm::dot(k, e) * (1. - std::cos(angle))),
      0.);
  }
  return m;
}

//------------------------------------------------------------------------------
glm::dmat4 MoveBy(const glm::dvec3& by)
{
  glm::dmat4 m(1.);
  m[3] = glm::dvec4(by, 1.);
  return m;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> MatrixArray(const char* name, const std::vector<glm::dmat4>& matrices)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(16);
  for (const glm::dmat4& m : matrices)
  {
    for (int i = 0; i < 16; ++i)
    {
      array->InsertNextValue(m[i % 4][i / 4]);
    }
  }
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSkeleton(const std::vector<glm::dmat4>& pose)
{
  return MakeSkeleton(pose, pose, 0.);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSkeleton(
  const std::vector<glm::dmat4>& before, const std::vector<glm::dmat4>& after, double share)
{
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const glm::dmat4& m : before)
  {
    points->InsertNextPoint(m[3].x, m[3].y, m[3].z);
  }
  skeleton->SetPoints(points);
  skeleton->GetPointData()->AddArray(MatrixArray("pose", before));
  skeleton->GetPointData()->AddArray(MatrixArray("pose_before", before));
  skeleton->GetPointData()->AddArray(MatrixArray("pose_after", after));
  vtkNew<vtkDoubleArray> part;
  part->SetName("key_share");
  part->InsertNextValue(share);
  skeleton->GetFieldData()->AddArray(part);
  return skeleton;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTube(int rings, int sides, bool wide)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(wide ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double angle = 2. * 3.14159265358979323846 * j / sides;
      points->InsertNextPoint(4. * i / (rings - 1), std::cos(angle), std::sin(angle));
      normals->InsertNextTuple3(0., std::cos(angle), std::sin(angle));
      if (i > 0)
      {
        const vtkIdType next = (j + 1) % sides;
        const vtkIdType row = static_cast<vtkIdType>(i) * sides;
        const vtkIdType quad[4] = { row - sides + j, row - sides + next, row + next, row + j };
        polys->InsertNextCell(4, quad);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

//------------------------------------------------------------------------------
void SetBones(vtkPolyData* mesh, const std::vector<glm::dmat4>& offsets, int components,
  const std::vector<int>& joints, const std::vector<float>& weights)
{
  vtkNew<vtkIntArray> nodes;
  nodes->SetName("bone_node");
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    nodes->InsertNextValue(static_cast<int>(i));
  }
  mesh->GetFieldData()->AddArray(nodes);
  mesh->GetFieldData()->AddArray(MatrixArray("bone_offset", offsets));
  vtkNew<vtkIntArray> places;
  places->SetName("joints");
  places->SetNumberOfComponents(components);
  for (const int joint : joints)
  {
    places->InsertNextValue(joint);
  }
  vtkNew<vtkFloatArray> shares;
  shares->SetName("weights");
  shares->SetNumberOfComponents(components);
  for (const float weight : weights)
  {
    shares->InsertNextValue(weight);
  }
  mesh->GetPointData()->AddArray(places);
  mesh->GetPointData()->AddArray(shares);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTwoBoneTube(int rings, int sides, bool wide)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeTube(rings, sides, wide);
  std::vector<int> joints;
  std::vector<float> weights;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto second = static_cast<float>(PointOf(mesh, i).x / 4.);
    joints.insert(joints.end(), { 0, 1 });
    weights.insert(weights.end(), { 1.f - second, second });
  }
  SetBones(mesh, { glm::dmat4(1.), glm::dmat4(1.) }, 2, joints, weights);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Skin(vtkPolyData* mesh, vtkPolyData* skeleton, int method)
{
  vtkNew<vtkRelievoSkin> skin;
  skin->SetInputData(0, mesh);
  skin->SetInputData(1, skeleton);
  skin->SetMethod(method);
  skin->Update();
  vtkSmartPointer<vtkPolyData> output = skin->GetOutput();
  return output;
}

//------------------------------------------------------------------------------
glm::dvec3 PointOf(vtkPolyData* mesh, vtkIdType i)
{
  double p[3];
  mesh->GetPoint(i, p);
  return glm::dvec3(p[0], p[1], p[2]);
}
}
