// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The buffer of casters' triangles by itself: trees that are fitted to points that move and built
// anew for other cells, and more casters than it can count, which are refused in words.
#include "vtkRelievoShadowTree.h" // before all of GLM, whose functions it has of its own

#include "Check.h"
#include "Session.h"
#include "Stage.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>

#include <memory>
#include <string>
#include <vector>

namespace
{
using relievoTest::Stage;

vtkSmartPointer<vtkPolyData> MakeBall()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  ball->Update();
  return ball->GetOutput();
}

void Move(vtkPolyData* mesh, double factor, double by)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    mesh->GetPoints()->SetPoint(i, factor * p[0] + by, p[1], p[2]);
  }
  mesh->GetPoints()->Modified();
}

void TestRefit(vtkOpenGLRenderWindow* window)
{
  const auto first = MakeBall();
  const auto second = MakeBall();
  std::vector<vtkRelievoCaster> casters(2);
  casters[0].Mesh = first;
  casters[1].Mesh = second;
  vtkRelievoShadowTree tree;
  const auto update = [&](int built, int refitted, const std::string& what) {
    const double version = tree.GetVersion();
    const std::string fault = tree.Update(window, casters, glm::dvec3(0.));
    RELIEVO_CHECK_THAT(fault.empty(), what + ": " + fault);
    RELIEVO_CHECK_THAT(tree.GetMeshesBuilt() == built && tree.GetMeshesRefitted() == refitted,
      what + ": " + std::to_string(tree.GetMeshesBuilt()) + " built, " +
        std::to_string(tree.GetMeshesRefitted()) + " fitted");
    RELIEVO_CHECK_THAT((tree.GetVersion() != version) == (built + refitted > 0), what);
  };
  update(2, 0, "new");
  update(0, 0, "the same");
  Move(first, 1.2, 0.3);
  update(0, 1, "points moved");
  Move(first, 1.1, 0.);
  Move(second, 1.1, 0.);
  update(0, 2, "points of both moved");
  first->GetPolys()->Modified();
  update(1, 0, "other cells");
  // Neighbours that are none any more: a tree that is fitted to them would be a bad one.
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    const double at = static_cast<double>(i * 7919 % 1000);
    second->GetPoints()->SetPoint(i, at, static_cast<double>(i * 104729 % 1000), at);
  }
  second->GetPoints()->Modified();
  update(1, 0, "points scattered");
  tree.Release(window);
}

// Places that are shared by many casters: more than a float counts.
void TestTooMany(vtkOpenGLRenderWindow* window)
{
  const auto ball = MakeBall();
  const auto places = std::make_shared<const std::vector<glm::mat4>>(1 << 20);
  vtkRelievoCaster caster;
  caster.Mesh = ball;
  caster.Places = places;
  vtkRelievoShadowTree tree;
  const std::string fault =
    tree.Update(window, std::vector<vtkRelievoCaster>(9, caster), glm::dvec3(0.));
  RELIEVO_CHECK_THAT(
    fault == "there are 9437184 casters and glyphs, and at most 8388608 can be followed", fault);
  RELIEVO_CHECK(tree.GetBytes() == 0);
  // What is less again, is followed again.
  caster.Places = nullptr;
  RELIEVO_CHECK(tree.Update(window, { caster }, glm::dvec3(0.)).empty());
  RELIEVO_CHECK(tree.GetBytes() > 0);
  tree.Release(window);
  RELIEVO_CHECK(tree.GetBytes() == 0);
}
}

//------------------------------------------------------------------------------
int main()
{
  relievoTest::Session session;
  {
    Stage stage(32, 32);
    stage.Window->Render();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
    TestRefit(window);
    TestTooMany(window);
  }
  return session.Result();
}
