// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which bones move a mesh: the first bone of each point, the weights of one bone by number and by
// name, before and after the mesh is moved.
#include "Check.h"
#include "Session.h"
#include "SkinScenes.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoBoneWeights.h>
#include <vtkRelievoSkin.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace testBoneWeights
{
namespace
{
using namespace relievoTest;

// Bone 0 of the mesh is point 2 of the skeleton, bone 1 is point 1.
vtkSmartPointer<vtkPolyData> MakeMesh()
{
  auto tube = MakeTwoBoneTube(17, 8);
  auto* nodes = vtkIntArray::SafeDownCast(tube->GetFieldData()->GetArray("bone_node"));
  nodes->SetValue(0, 2);
  nodes->SetValue(1, 1);
  return tube;
}

vtkSmartPointer<vtkPolyData> MakeNamedSkeleton()
{
  auto skeleton = MakeSkeleton({ glm::dmat4(1.), glm::dmat4(1.), glm::dmat4(1.) });
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  names->InsertNextValue("root");
  names->InsertNextValue("hand");
  names->InsertNextValue("arm");
  skeleton->GetPointData()->AddArray(names);
  return skeleton;
}

void TestValues()
{
  vtkNew<vtkRelievoBoneWeights> filter;
  filter->SetInputData(0, MakeMesh());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  RELIEVO_CHECK(output->GetPointData()->GetArray("bone_weight") == nullptr);
  for (const bool named : { false, true })
  {
    if (named)
    {
      filter->SetInputData(1, MakeNamedSkeleton());
      filter->SetBoneName("hand");
      filter->SetBone(0);
    }
    else
    {
      filter->SetBone(1);
    }
    filter->Update();
    vtkDataArray* firsts = output->GetPointData()->GetArray("first_bone");
    vtkDataArray* shares = output->GetPointData()->GetArray("bone_weight");
    RELIEVO_CHECK(firsts && shares);
    double off = 0.;
    int mismatches = 0;
    for (vtkIdType i = 0; firsts && shares && i < output->GetNumberOfPoints(); ++i)
    {
      const double share = PointOf(output, i).x / 4.;
      off = Larger(off, std::abs(shares->GetComponent(i, 0) - share));
      const double first = share > 0.5 ? 1. : 2.;
      mismatches += std::abs(share - 0.5) > 1e-6 && firsts->GetComponent(i, 0) != first ? 1 : 0;
    }
    RELIEVO_CHECK_AT_MOST(off, 1e-6, "weights of one bone");
    RELIEVO_CHECK_AT_MOST(mismatches, 0, "points with another first bone");
  }
  // Added arrays stay with the moved mesh.
  const auto moved = Skin(output, MakeNamedSkeleton(), vtkRelievoSkin::LINEAR);
  RELIEVO_CHECK(moved->GetPointData()->GetArray("first_bone") != nullptr);
  RELIEVO_CHECK(moved->GetPointData()->GetArray("bone_weight") != nullptr);
}

// Weights that do not sum to 1, points without bones, joints that are not there.
void TestOddWeights()
{
  const auto tube = MakeTube(3, 4, false);
  std::vector<int> joints;
  std::vector<float> weights;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    joints.insert(joints.end(), { i % 3 == 0 ? -1 : 0, 9 });
    weights.insert(weights.end(), { i % 3 == 1 ? 0.f : 5.f, NAN });
  }
  SetBones(tube, { glm::dmat4(1.) }, 2, joints, weights);
  vtkNew<vtkRelievoBoneWeights> filter;
  filter->SetInputData(0, tube);
  filter->SetBone(0);
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const bool held = i % 3 == 2;
    RELIEVO_CHECK(data->GetArray("first_bone")->GetComponent(i, 0) == (held ? 0. : -1.));
    RELIEVO_CHECK(data->GetArray("bone_weight")->GetComponent(i, 0) == (held ? 1. : 0.));
  }
}

void TestMissing()
{
  vtkNew<vtkRelievoBoneWeights> filter;
  filter->SetInputData(0, MakeMesh());
  filter->SetBoneName("foot");
  {
    ExpectMessage expect("no skeleton");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  {
    ExpectMessage expect("no bone foot");
    filter->SetInputData(1, MakeNamedSkeleton());
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetArray("first_bone") != nullptr);
    RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetArray("bone_weight") == nullptr);
  }
  {
    ExpectMessage expect("joints and weights");
    filter->SetInputData(0, MakeTube(3, 4, false));
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 12);
  }
  // Once for all blocks, and again when it is asked again.
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    blocks->SetBlock(i, MakeMesh());
  }
  vtkNew<vtkRelievoBoneWeights> all;
  all->SetInputDataObject(0, blocks);
  all->SetInputData(1, MakeNamedSkeleton());
  all->SetBoneName("foot");
  for (int i = 1; i <= 2; ++i)
  {
    ExpectMessage expect("no bone foot");
    all->Modified();
    all->Update();
    RELIEVO_CHECK_THAT(expect.Count() == 1, std::to_string(expect.Count()) + " messages");
  }
  vtkNew<vtkRelievoSkin> skin;
  skin->SetInputDataObject(0, blocks);
  skin->SetInputData(1, MakeSkeleton({ glm::dmat4(1.) }));
  ExpectMessage expect("of a skeleton of 1");
  skin->Update();
  RELIEVO_CHECK_THAT(expect.Count() == 1, std::to_string(expect.Count()) + " messages");
}

// A mesh that was moved has no numbers of the skeleton.
void TestMoved()
{
  const auto moved = Skin(MakeMesh(), MakeNamedSkeleton(), vtkRelievoSkin::LINEAR);
  vtkNew<vtkRelievoBoneWeights> filter;
  filter->SetInputData(0, moved);
  filter->SetBone(1);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetArray("first_bone") != nullptr);
  RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetArray("bone_weight") == nullptr);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBoneWeights)
{
  relievoTest::Session session;
  TestValues();
  TestOddWeights();
  TestMissing();
  TestMoved();
  return session.Result();
}
}
