// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Failures of skinning: invalid weights and joints, bones that flatten, missing parts.
#include "Check.h"
#include "Session.h"
#include "SkinScenes.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoSkin.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace testSkinFailures
{
namespace
{
using namespace relievoTest;
constexpr int Methods[] = { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION,
  vtkRelievoSkin::KEY_MATRIX };
const auto Move = MoveBy(glm::dvec3(1., 2., 3.));

// Four points at (1, 0, 0), with two joints each.
vtkSmartPointer<vtkPolyData> MakePoints(
  const std::vector<int>& joints, const std::vector<float>& weights)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (std::size_t i = 0; i < joints.size() / 2; ++i)
  {
    points->InsertNextPoint(1., 0., 0.);
  }
  mesh->SetPoints(points);
  SetBones(mesh, { glm::dmat4(1.), glm::dmat4(1.) }, 2, joints, weights);
  return mesh;
}

void TestWeights()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::dvec3 stays(1., 0., 0.);
  const glm::dvec3 moved(2., 2., 3.);
  const vtkSmartPointer<vtkPolyData> mesh = MakePoints(
    { 0, 1, /**/ -1, -1, /**/ 0, 1, /**/ 1, 7, /**/ 1, 0, /**/ 1, -5, /**/ 0, 1 },
    { 0.f, 0.f, /**/ 1.f, 1.f, /**/ nan, 1.f, /**/ 0.5f, 0.5f, /**/ 0.2f, -1.f, /**/ 3.f, 2.f, /**/
      1.f, 1.f });
  const glm::dvec3 expected[] = { stays, stays, moved, moved, moved, moved, (stays + moved) * 0.5 };
  for (const int method : Methods)
  {
    const auto output = Skin(mesh, MakeSkeleton({ glm::dmat4(1.), Move }), method);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      RELIEVO_CHECK_AT_MOST(glm::length(PointOf(output, i) - expected[i]), 1e-6,
        "point " + std::to_string(i) + " of method " + std::to_string(method));
    }
  }
}

// Bones that flatten or vanish give finite points and normals.
void TestFlatBones()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(9, 6);
  std::vector<glm::dmat4> flats(4, glm::dmat4(1.));
  flats[0][0] = glm::dvec4(0.);                       // along x
  flats[1][1] = flats[1][2] = glm::dvec4(0.);         // onto a line
  flats[2] = MoveBy(glm::dvec3(1.)) * glm::dmat4(0.); // nothing, not even the last row
  flats[2][3] = glm::dvec4(1., 1., 1., 1.);
  flats[3][1] = flats[3][0];
  for (const glm::dmat4& flat : flats)
  {
    for (const int method : Methods)
    {
      const auto output = Skin(tube, MakeSkeleton({ glm::dmat4(1.), flat }), method);
      for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
      {
        double n[3];
        output->GetPointData()->GetNormals()->GetTuple(i, n);
        const double length = std::hypot(n[0], n[1], n[2]);
        const glm::dvec3 p = PointOf(output, i);
        RELIEVO_CHECK(std::isfinite(p.x + p.y + p.z) && std::abs(length - 1.) < 1e-5);
        const glm::dvec3 at = PointOf(tube, i);
        const glm::dvec3 own(flat * glm::dvec4(at, 1.));
        const glm::dvec3 mean = at * (1. - at.x / 4.) + own * (at.x / 4.);
        if (method == vtkRelievoSkin::LINEAR || at.x == 4. || at.x == 0.)
        {
          RELIEVO_CHECK_AT_MOST(glm::length(p - mean), 1e-5, "point of a flat bone");
        }
      }
    }
  }
}

void ExpectRefusal(vtkPolyData* mesh, vtkPolyData* skeleton, int method, const std::string& words)
{
  ExpectMessage expect(words);
  const auto output = Skin(mesh, skeleton, method);
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(output->GetNumberOfPoints() == 0);
}

void TestMissing()
{
  const auto skeleton = MakeSkeleton({ glm::dmat4(1.), Move });
  for (const char* name : { "joints", "weights" })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeTwoBoneTube(3, 6);
    mesh->GetPointData()->RemoveArray(name);
    ExpectRefusal(mesh, skeleton, 0, "no point arrays joints and weights");
  }
  for (const char* name : { "bone_node", "bone_offset" })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeTwoBoneTube(3, 6);
    mesh->GetFieldData()->RemoveArray(name);
    ExpectRefusal(mesh, skeleton, 0, "the mesh has no bones");
  }
  const vtkSmartPointer<vtkPolyData> mesh = MakeTwoBoneTube(3, 6);
  ExpectRefusal(mesh, MakeSkeleton({ Move }), 0, "bone 1 names point 1 of a skeleton of 1");
  const auto bare = MakeSkeleton({ Move, Move });
  bare->GetPointData()->RemoveArray("pose_after");
  ExpectRefusal(mesh, bare, vtkRelievoSkin::KEY_MATRIX, "no whole keys");
  bare->GetPointData()->RemoveArray("pose");
  ExpectRefusal(mesh, bare, vtkRelievoSkin::LINEAR, "no point array pose");
  for (const bool tangents : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> few = MakeTwoBoneTube(3, 6);
    vtkNew<vtkFloatArray> directions;
    directions->SetName("few");
    directions->SetNumberOfComponents(3);
    directions->InsertNextTuple3(0., 0., 1.);
    vtkPointData* data = few->GetPointData();
    tangents ? data->SetTangents(directions) : data->SetNormals(directions);
    ExpectRefusal(few, skeleton, 0, "the point array few has 1 tuples, for 18 points");
  }
  // Moved once, a mesh is refused: it would be moved from where it is.
  const auto once = Skin(mesh, skeleton, 0);
  ExpectRefusal(once, skeleton, 0, "the mesh has no bones");
  vtkNew<vtkPolyData> nothing;
  RELIEVO_CHECK(Skin(nothing, skeleton, 0)->GetNumberOfPoints() == 0);
}

// A composite is moved block by block.
void TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTwoBoneTube(3, 6));
  blocks->SetBlock(2, MakeTwoBoneTube(5, 6));
  vtkNew<vtkRelievoSkin> skin;
  skin->SetInputDataObject(0, blocks);
  skin->SetInputData(1, MakeSkeleton({ Move, Move }));
  skin->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(skin->GetOutputDataObject(0));
  if (RELIEVO_CHECK(output && output->GetNumberOfBlocks() == 3))
  {
    for (const unsigned int block : { 0u, 2u })
    {
      auto* mesh = vtkPolyData::SafeDownCast(output->GetBlock(block));
      auto* rest = vtkPolyData::SafeDownCast(blocks->GetBlock(block));
      RELIEVO_CHECK(
        mesh && glm::length(PointOf(mesh, 4) - PointOf(rest, 4) - glm::dvec3(1., 2., 3.)) < 1e-6);
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinFailures)
{
  relievoTest::Session session;
  TestWeights();
  TestFlatBones();
  TestMissing();
  TestComposite();
  return session.Result();
}
}
