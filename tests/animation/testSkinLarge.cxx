// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh of ten million points through vtkRelievoSkin.
#include "Check.h"
#include "Session.h"
#include "SkinScenes.h"
#include "TestCase.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRelievoSkin.h>

#include <glm/geometric.hpp>

#include <vector>

namespace testSkinLarge
{
namespace
{
using namespace relievoTest;

void TestLarge()
{
  constexpr vtkIdType Count = 10'000'000;
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(Count);
  std::vector<int> joints(2 * Count, 0);
  std::vector<float> weights(2 * Count, 0.f);
  for (vtkIdType i = 0; i < Count; ++i)
  {
    const double along = static_cast<double>(i) / Count;
    points->SetPoint(i, along, 1., 0.);
    const auto at = static_cast<std::size_t>(2 * i);
    joints[at + 1] = 1;
    weights[at] = static_cast<float>(1. - along);
    weights[at + 1] = static_cast<float>(along);
  }
  mesh->SetPoints(points);
  SetBones(mesh, { glm::dmat4(1.), glm::dmat4(1.) }, 2, joints, weights);
  const auto skeleton = MakeSkeleton({ glm::dmat4(1.), MoveBy({ 1., 2., 3. }) });
  for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    const auto moved = Skin(mesh, skeleton, method);
    RELIEVO_CHECK(moved->GetNumberOfPoints() == Count);
    double off = 0.;
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); i += 997)
    {
      const double along = static_cast<double>(i) / Count;
      const glm::dvec3 expected(2. * along, 1. + 2. * along, 3. * along);
      off = Larger(off, glm::distance(PointOf(moved, i), expected));
    }
    RELIEVO_CHECK_AT_MOST(off, 1e-6, "points of ten million");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinLarge)
{
  relievoTest::Session session;
  TestLarge();
  return session.Result();
}
}
