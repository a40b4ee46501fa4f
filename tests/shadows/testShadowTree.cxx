// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The buffer of casters' triangles by itself: trees that are fitted to points that move and built
// anew for other cells, and more casters than it can count or than OpenGL's buffers hold, which are
// refused in words; and the maps that a picture then has.
#include "vtkRelievoCasterRays.h" // before all of GLM, whose functions it has of its own
#include "vtkRelievoTreeBuffer.h"

#include "AddressLimit.h"
#include "Check.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "Stage.h"
#include "TestCase.h"
#include "vtkRelievoTextureBuffer.h"
#include "vtkRelievoThreads.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace testShadowTree
{
namespace
{
using relievoTest::Stage;

#include "rays/leaves.glsl"

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
  std::vector<vtkRelievoPlacedMesh> casters(2);
  casters[0].Mesh = first;
  casters[1].Mesh = second;
  vtkRelievoTreeBuffer tree;
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

// Nodes in texels, at places of the largest trees: the shader's indices are those of the nodes.
void TestIndices()
{
  constexpr int LeafSize = 4;
  constexpr int MostNodes = 2 * vtkRelievoBoxTree::MostLeaves - 1;
  long long mismatches = 0;
  for (int node = 0; node < MostNodes; node += 1 + node / 100)
  {
    for (int leaves = 2; leaves <= (MostNodes - node + 1) / 2; leaves += 1 + leaves / 100)
    {
      vtkRelievoBoxTree::Node inner{};
      inner.Next = node + 2 * leaves - 1;
      const float w = inner.GetTexels(node, LeafSize)[0].w;
      mismatches += w >= 0.f && node + relievoTreeNodesOf(w) == inner.Next ? 0 : 1;
    }
    const int first = std::min(LeafSize * (node / 2), LeafSize * vtkRelievoBoxTree::MostLeaves - 4);
    vtkRelievoBoxTree::Node leaf{};
    leaf.Next = -1 - first;
    leaf.Count = 3;
    const auto texels = leaf.GetTexels(node, LeafSize);
    mismatches += texels[0].w < 0.f && relievoTreeLeafFirst(texels[0].w) == first ? 0 : 1;
    mismatches += texels[1].w == 3.f ? 0 : 1;
    leaf.Next = -1 - node / 2; // of a tree with one box in a leaf
    mismatches += relievoTreeLeaf(leaf.GetTexels(node, 1)[0].w) == node / 2 ? 0 : 1;
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "indices of nodes and leaves");
}

// Places that are shared by many casters: more than a float counts.
void TestTooMany(vtkOpenGLRenderWindow* window)
{
  const auto ball = MakeBall();
  const auto places = std::make_shared<const std::vector<glm::dmat4>>(1 << 20);
  vtkRelievoPlacedMesh caster;
  caster.Mesh = ball;
  caster.Places = places;
  vtkRelievoTreeBuffer tree;
  const std::string fault =
    tree.Update(window, std::vector<vtkRelievoPlacedMesh>(17, caster), glm::dvec3(0.));
  RELIEVO_CHECK_THAT(
    fault == "there are 17825792 casters and glyphs, and at most 16777216 are supported", fault);
  RELIEVO_CHECK(tree.GetBytes() == 0);
  // A scene that becomes smaller again is traced again.
  caster.Places = nullptr;
  RELIEVO_CHECK(tree.Update(window, { caster }, glm::dvec3(0.)).empty());
  RELIEVO_CHECK(tree.GetBytes() > 0);
  tree.Release(window);
  RELIEVO_CHECK(tree.GetBytes() == 0);
}

// Lack of memory in a thread reaches the caller, who may use threads again.
void TestThreads()
{
  const std::string backend = vtkSMPTools::GetBackend();
  bool lacks = false;
  try
  {
    vtkRelievoForAll(64, [](vtkIdType i) {
      if (i == 40)
      {
        throw std::bad_alloc();
      }
    });
  }
  catch (const std::bad_alloc&)
  {
    lacks = true;
  }
  RELIEVO_CHECK(lacks);
  RELIEVO_CHECK(vtkSMPTools::GetBackend() == backend);
}

// Little address space is left: neither shaders' trees nor rays on the processor have a mesh then.
void TestLackOfMemory(vtkOpenGLRenderWindow* window)
{
  constexpr int Side = 600;
  constexpr double Left = 8 << 20; // below the 45 bytes of a triangle that rays need
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(Side, Side);
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputConnection(plane->GetOutputPort());
  cut->Update();
  vtkRelievoSurface surface;
  surface.Caster.Mesh = cut->GetOutput();
  vtkRelievoTreeBuffer tree;
  vtkRelievoCasterRays rays;
  const auto update = [&]() { return tree.Update(window, { surface.Caster }, glm::dvec3(0.)); };
  std::string fault, lack;
  {
    const relievoTest::AddressLimit limit(Left);
    fault = update();
    lack = rays.SetSurfaces({ surface });
  }
  RELIEVO_CHECK_THAT(
    fault == "memory ran out while a tree of the casters' triangles was built", fault);
  RELIEVO_CHECK(tree.GetBytes() == 0);
  RELIEVO_CHECK_THAT(lack.compare(0, 14, "it would take ") == 0, lack);
  RELIEVO_CHECK(rays.GetSurfaces().empty() && rays.GetNumberOfTriangles() == 0);
  RELIEVO_CHECK(update().empty());
  RELIEVO_CHECK(tree.GetNumberOfTriangles() == 2 * Side * Side);
  RELIEVO_CHECK(rays.SetSurfaces({ surface }).empty());
  RELIEVO_CHECK(rays.GetNumberOfTriangles() == 2 * Side * Side);
  tree.Release(window);
}

// An OpenGL whose buffers are too small.
void TestSmallBuffers(vtkOpenGLRenderWindow* window)
{
  const auto ball = MakeBall();
  vtkRelievoPlacedMesh caster;
  caster.Mesh = ball;
  vtkRelievoTreeBuffer tree;
  RELIEVO_CHECK(tree.Update(window, { caster }, glm::dvec3(0.)).empty());
  const vtkIdType texels = tree.GetBytes() / 16;
  vtkRelievoTextureBuffer::SetMostTexels(static_cast<int>(texels) - 1);
  // Existing data stays until something changes.
  RELIEVO_CHECK(tree.Update(window, { caster }, glm::dvec3(0.)).empty());
  const std::string fault = tree.Update(window, { caster }, glm::dvec3(1.));
  RELIEVO_CHECK_THAT(fault ==
      "the casters' triangles take " + std::to_string(texels) +
        " texels, but this OpenGL supports buffers of at most " + std::to_string(texels - 1),
    fault);
  RELIEVO_CHECK(tree.GetBytes() == 0);
  vtkRelievoTextureBuffer::SetMostTexels(static_cast<int>(texels));
  RELIEVO_CHECK(tree.Update(window, { caster }, glm::dvec3(1.)).empty());
  RELIEVO_CHECK(tree.GetBytes() == 16 * texels);
  vtkRelievoTextureBuffer::SetMostTexels(0);
}

// A picture by such an OpenGL has the shadows of maps, and one warning for any number of frames;
// once the casters have changed, and fit, the rays are back.
void TestFallback(bool planned)
{
  constexpr int Exact = vtkRelievoShadowStage::METHOD_EXACT;
  relievoTest::ShadowStage stage;
  stage.AddThings();
  const auto box = stage.AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  const std::string what = planned ? "planned" : "chosen";
  const auto capture = [&stage]() {
    return relievoTest::Layers(relievoTest::CaptureShadow(stage, 0));
  };
  const auto checkSame = [&](const relievoTest::Layers& a, const relievoTest::Layers& b) {
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(a, b, "shadow_0"), 0, what + ": pixels unlike");
  };
  shadows->SetMapSize(256); // unlike exact ones
  const relievoTest::Layers map = capture();
  shadows->SetMethodToExact();
  shadows->SetTolerance(planned ? 2e-5 : 0.);
  const relievoTest::Layers exact = capture();
  RELIEVO_CHECK_THAT(shadows->GetMethodUsed() == Exact, what + ": not exact");
  RELIEVO_CHECK(relievoTest::CountDifferent(map, exact, "shadow_0") > 100);
  vtkRelievoTextureBuffer::SetMostTexels(64);
  checkSame(exact, capture()); // existing buffers stay
  {
    const relievoTest::ExpectMessage expected("buffers of at most 64");
    for (int frame = 0; frame < 4; ++frame)
    {
      box->SetPosition(0., 0.1 * ((frame + 1) % 2), 0.);
      stage.Window->Render();
      const relievoTest::Layers fallback = capture();
      RELIEVO_CHECK_THAT(shadows->GetMethodUsed() != Exact, what + ": exact all the same");
      if (!planned && frame % 2 == 1)
      {
        RELIEVO_CHECK(shadows->GetMethodUsed() == vtkRelievoShadowStage::METHOD_MAP);
        checkSame(map, fallback);
      }
    }
    RELIEVO_CHECK_AT_MOST(expected.Count(), 1, what + ": warnings");
    const std::string said = expected.Messages().empty() ? std::string() : expected.Messages()[0];
    RELIEVO_CHECK_THAT(
      said.find("Shadows are made with maps: the casters' triangles take ") != std::string::npos,
      what + ": " + said);
    const std::string plan = shadows->GetPlan();
    RELIEVO_CHECK_THAT(!planned || plan.find("not met") != std::string::npos, plan);
  }
  vtkRelievoTextureBuffer::SetMostTexels(0);
  box->SetPosition(0., 0.1, 0.);
  capture();
  RELIEVO_CHECK_THAT(shadows->GetMethodUsed() == Exact, what + ": no rays again");
  box->SetPosition(0., 0., 0.); // where they were refused at last
  checkSame(exact, capture());
  RELIEVO_CHECK_THAT(shadows->GetMethodUsed() == Exact, what + ": rays are refused for ever");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowTree)
{
  relievoTest::Session session;
  TestIndices();
  {
    Stage stage(32, 32);
    stage.Window->Render();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
    TestThreads();
    if (relievoTest::AddressLimit::IsUsable)
    {
      TestLackOfMemory(window); // before others free memory that it would use
    }
    TestRefit(window);
    TestTooMany(window);
    TestSmallBuffers(window);
  }
  TestFallback(false);
  TestFallback(true);
  return session.Result();
}
}
