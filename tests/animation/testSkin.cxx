// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Skinning compared with closed forms: twist and bend of a tube by each method; points and normals
// of bones that stretch, mirror and rotate, compared with matrices in double.
#include "Check.h"
#include "Session.h"
#include "SkinScenes.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoSkin.h>
#include <vtkSMPTools.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testSkin
{
namespace
{
using namespace relievoTest;
constexpr double Pi = 3.14159265358979323846;
constexpr int Methods[] = { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION,
  vtkRelievoSkin::KEY_MATRIX };

double Radius(const glm::dvec3& p)
{
  return std::hypot(p.y, p.z);
}

glm::dvec3 NormalOf(vtkPolyData* mesh, vtkIdType i)
{
  double n[3];
  mesh->GetPointData()->GetNormals()->GetTuple(i, n);
  return glm::dvec3(n[0], n[1], n[2]);
}

// The middle of a tube whose ends are turned against each other shrinks to cos(angle / 2) by
// matrices, and keeps its radius by dual quaternions.
void TestTwist()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(65, 24);
  const vtkIdType middle = 32 * 24;
  for (const double degrees : { 0., 30., 90., 150., 180. })
  {
    const double angle = degrees * Pi / 180.;
    const auto skeleton =
      MakeSkeleton({ glm::dmat4(1.), TurnAbout(glm::dvec3(1., 0., 0.), angle) });
    const auto linear = Skin(tube, skeleton, vtkRelievoSkin::LINEAR);
    const auto dual = Skin(tube, skeleton, vtkRelievoSkin::DUAL_QUATERNION);
    double off = 0.;
    double across = 0.;
    for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
    {
      off = Larger(off, std::abs(Radius(PointOf(dual, i)) - 1.));
      const glm::dvec3 p = PointOf(dual, i);
      across =
        Larger(across, glm::length(NormalOf(dual, i) - glm::dvec3(0., p.y, p.z) / Radius(p)));
    }
    RELIEVO_CHECK_AT_MOST(off, degrees == 180. ? 0.01 : 1e-5, "radius by dual quaternions");
    RELIEVO_CHECK_AT_MOST(across, 1e-5, "normals by dual quaternions");
    RELIEVO_CHECK_NEAR(Radius(PointOf(linear, middle)), std::cos(angle / 2.), 1e-6,
      "radius of the middle by matrices");
    // Turned by half the angle, in the middle.
    const glm::dvec3 p = PointOf(dual, middle + 5);
    const glm::dvec3 half(
      TurnAbout(glm::dvec3(1., 0., 0.), angle / 2.) * glm::dvec4(PointOf(tube, middle + 5), 1.));
    if (degrees < 180.) // at 180 either way round is as short
    {
      RELIEVO_CHECK_AT_MOST(glm::length(p - half), 1e-5, "half the twist in the middle");
    }
  }
}

// A bone's matrix and its rotation by a full turn more are one matrix, whose quaternions differ in
// sign: bones whose quaternions lie in opposite halves must not tear the mesh.
void TestHalves()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(33, 12);
  for (int i = 0; i <= 36; ++i)
  {
    const double angle = 10. * i * Pi / 180.;
    const glm::dmat4 turn = TurnAbout(glm::dvec3(1., 2., -0.5), angle);
    const glm::dmat4 more = turn * TurnAbout(glm::dvec3(1., 0., 0.), 0.2);
    const auto dual = Skin(tube, MakeSkeleton({ turn, more }), vtkRelievoSkin::DUAL_QUATERNION);
    const glm::dmat3 back = glm::transpose(glm::dmat3(turn));
    double off = 0.;
    for (vtkIdType j = 0; j < tube->GetNumberOfPoints(); ++j)
    {
      const glm::dvec3 p = back * PointOf(dual, j);
      off = Larger(off, Larger(std::abs(Radius(p) - 1.), std::abs(p.x - PointOf(tube, j).x)));
    }
    RELIEVO_CHECK_AT_MOST(off, 1e-4, "radius where quaternions change sign");
  }
}

// One bone that does anything: every method gives the matrix itself, and normals by its inverse
// transpose.
void TestOneBone(bool wide)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int round = 0; round < 30; ++round)
  {
    const vtkSmartPointer<vtkPolyData> tube = MakeTube(5, 8, wide);
    const auto count = static_cast<std::size_t>(tube->GetNumberOfPoints());
    glm::dmat4 offset = MoveBy(glm::dvec3(uniform(random), uniform(random), uniform(random)));
    glm::dmat4 pose = TurnAbout(
      glm::dvec3(uniform(random), uniform(random), uniform(random) + 2.), 6. * uniform(random));
    // Stretched, sheared and in a third of the rounds mirrored.
    pose[0] *= round % 3 == 0 ? -0.5 : 2.;
    pose[1] += pose[2] * uniform(random);
    pose[3] = glm::dvec4(uniform(random), 3. * uniform(random), uniform(random), 1.);
    SetBones(tube, { offset }, 1, std::vector<int>(count, 0), std::vector<float>(count, 1.f));
    const glm::dmat4 whole = pose * offset;
    const glm::dmat3 normal = glm::inverse(glm::transpose(glm::dmat3(whole)));
    for (const int method : Methods)
    {
      const auto moved = Skin(tube, MakeSkeleton({ pose }), method);
      double off = 0.;
      double turned = 0.;
      for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
      {
        const glm::dvec3 expected(whole * glm::dvec4(PointOf(tube, i), 1.));
        off = Larger(off, glm::length(PointOf(moved, i) - expected));
        turned = Larger(
          turned, glm::length(NormalOf(moved, i) - glm::normalize(normal * NormalOf(tube, i))));
      }
      RELIEVO_CHECK_AT_MOST(off, wide ? 1e-13 : 1e-5, "a bone of any matrix, points");
      RELIEVO_CHECK_AT_MOST(turned, 2e-6, "a bone of any matrix, normals");
    }
  }
}

// Bones of any size turn normals, as far as floats have numbers for points.
void TestSizes()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(3, 8);
  for (const double size : { 1e-20, 1e-12, 1e-6, 1., 1e6, 1e12, 1e20 })
  {
    glm::dmat4 pose = TurnAbout(glm::dvec3(1., 2., 3.), 1.);
    const glm::dmat3 turn(pose);
    pose[0] *= size;
    pose[1] *= size;
    pose[2] *= size;
    for (const int method : Methods)
    {
      const auto moved = Skin(tube, MakeSkeleton({ pose, pose }), method);
      double turned = 0.;
      for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
      {
        turned = Larger(turned, glm::length(NormalOf(moved, i) - turn * NormalOf(tube, i)));
      }
      RELIEVO_CHECK_AT_MOST(
        turned, 2e-6, "normals of bones of the size " + std::to_string(std::log10(size)));
    }
  }
}

// A blend of moves is the mean move by every method, whatever stretches go along.
void TestMean()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(9, 6);
  glm::dmat4 far = MoveBy(glm::dvec3(0., 2., 0.));
  far[1] *= 3.; // stretched along y
  const auto skeleton = MakeSkeleton({ glm::dmat4(1.), far });
  for (const int method : Methods)
  {
    const auto moved = Skin(tube, skeleton, method);
    double off = 0.;
    for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 p = PointOf(tube, i);
      const double share = p.x / 4.;
      const glm::dvec3 expected(p.x, p.y * (1. + 2. * share) + 2. * share, p.z);
      off = Larger(off, glm::length(PointOf(moved, i) - expected));
    }
    RELIEVO_CHECK_AT_MOST(off, 2e-6, "blended move and stretch");
  }
}

// Whole keys are blended by components: a bone half-way through a turn of 90 degrees is shorter.
void TestKeyMatrices()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(3, 8);
  const glm::dmat4 turned = TurnAbout(glm::dvec3(1., 0., 0.), Pi / 2.);
  const auto skeleton = MakeSkeleton({ glm::dmat4(1.), glm::dmat4(1.) }, { turned, turned }, 0.5);
  const auto moved = Skin(tube, skeleton, vtkRelievoSkin::KEY_MATRIX);
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    RELIEVO_CHECK_NEAR(Radius(PointOf(moved, i)), std::sqrt(0.5), 1e-6, "radius between keys");
  }
}

// The number of threads changes no bit of points and normals.
void TestThreads()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(1001, 40); // several shares of the work
  const auto skeleton =
    MakeSkeleton({ MoveBy(glm::dvec3(0.1, 0.2, 0.3)), TurnAbout(glm::dvec3(1., 2., 3.), 1.) });
  for (const int method : Methods)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> made;
    for (const int threads : { 1, 2, 5 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&]() { made.push_back(Skin(tube, skeleton, method)); });
    }
    int differ = 0;
    for (std::size_t i = 1; i < made.size(); ++i)
    {
      for (vtkIdType j = 0; j < tube->GetNumberOfPoints(); ++j)
      {
        differ += PointOf(made[0], j) != PointOf(made[i], j);
        differ += NormalOf(made[0], j) != NormalOf(made[i], j);
      }
    }
    RELIEVO_CHECK(differ == 0);
  }
}

// The method changes nothing else, and the input is as it was.
void TestInputStays()
{
  const vtkSmartPointer<vtkPolyData> tube = MakeTwoBoneTube(5, 6);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(tube);
  const auto skeleton = MakeSkeleton({ MoveBy(glm::dvec3(1.)), TurnAbout(glm::dvec3(1.), 1.) });
  const auto moved = Skin(tube, skeleton, vtkRelievoSkin::DUAL_QUATERNION);
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    RELIEVO_CHECK(PointOf(tube, i) == PointOf(before, i));
    RELIEVO_CHECK(NormalOf(tube, i) == NormalOf(before, i));
  }
  RELIEVO_CHECK(moved->GetNumberOfCells() == tube->GetNumberOfCells());
  RELIEVO_CHECK(moved->GetPointData()->GetArray("joints") != nullptr);
  double box[6];
  moved->GetBounds(box);
  double widest = -1e9;
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    widest = std::max(widest, PointOf(moved, i).x);
  }
  RELIEVO_CHECK_NEAR(box[1], widest, 1e-6, "bounds follow");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkin)
{
  relievoTest::Session session;
  TestTwist();
  TestHalves();
  TestOneBone(false);
  TestOneBone(true);
  TestSizes();
  TestMean();
  TestKeyMatrices();
  TestThreads();
  TestInputStays();
  return session.Result();
}
}
