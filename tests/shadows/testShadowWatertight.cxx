// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of closed meshes of many small triangles, by rays that are aimed right at the edges
// and corners that these share: no light gets through, but where a piece is missing.
//
// From a lamp, each corner lies on the ray to a pixel's place on the ground. Each side of the mesh
// is moved along these rays, so that the rays meet the same edges of a surface that is no plane.
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace testShadowWatertight
{
namespace
{
using relievoTest::ShadowStage;

constexpr int Cells = 128;               // along a side of the mesh
constexpr int Side = 2 * Cells + 1;      // pixels
constexpr double Middle = 4.;            // the height of the mesh's middle, half of its side is 1
constexpr double Pixel = Middle / Cells; // on the ground
constexpr double Edge = Middle + 0.5 * Pixel;

// How far a corner is moved along its ray from the middle.
using Relief = double (*)(const glm::dvec3& onCube);

double Flat(const glm::dvec3&)
{
  return 1.;
}

double Bumpy(const glm::dvec3& p)
{
  return 1. + 0.1 * std::sin(37. * p.x + 5. * p.z) * std::cos(41. * p.z - 3. * p.y);
}

// The six sides of a cube, two triangles a cell, closed: corners on its edges are shared. Cells of
// the lower side from `hole` to less than `holeEnd`, along both axes, are missing.
vtkSmartPointer<vtkPolyData> MakeClosed(Relief relief, int hole, int holeEnd)
{
  std::map<std::array<int, 3>, vtkIdType> ids;
  std::vector<glm::dvec3> points;
  const auto corner = [&](std::array<int, 3> at) {
    const auto found = ids.emplace(at, static_cast<vtkIdType>(points.size()));
    if (found.second)
    {
      const glm::dvec3 p(2. * at[0] / Cells - 1., 2. * at[1] / Cells - 1., 2. * at[2] / Cells - 1.);
      points.push_back(glm::dvec3(0., Middle, 0.) + relief(p) * p);
    }
    return found.first->second;
  };
  std::vector<std::array<vtkIdType, 4>> quads;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int end : { 0, Cells })
    {
      for (int i = 0; i < Cells; ++i)
      {
        for (int j = 0; j < Cells; ++j)
        {
          const auto missing = [&](int k) { return k >= hole && k < holeEnd; };
          if (axis == 1 && end == 0 && missing(i) && missing(j))
          {
            continue;
          }
          std::array<vtkIdType, 4> quad;
          for (int k = 0; k < 4; ++k)
          {
            std::array<int, 3> at;
            at[axis] = end;
            at[(axis + 1) % 3] = i + (k == 1 || k == 2 ? 1 : 0);
            at[(axis + 2) % 3] = j + (k >= 2 ? 1 : 0);
            quad[k] = corner(at);
          }
          quads.push_back(quad);
        }
      }
    }
  }
  const auto mesh = relievoTest::MakePolygons(points);
  for (std::size_t i = 0; i < quads.size(); ++i)
  {
    const auto& q = quads[i];
    // Diagonals of both directions.
    const std::size_t first = i % 3 == 0 ? 1 : 0;
    mesh->GetPolys()->InsertNextCell({ q[first], q[first + 1], q[first + 2] });
    mesh->GetPolys()->InsertNextCell({ q[first], q[first + 2], q[first == 1 ? 0 : 3] });
  }
  return mesh;
}

// The share of the light visible from a pixel's place: 0, 1, or -1 where an edge of the truth
// decides.
using Truth = double (*)(double x, double z);

void Check(ShadowStage& stage, Truth truth, long long leastDark, const std::string& what)
{
  for (int frame = 0; frame < 2; ++frame) // of each fragment's rays, and found pixel by pixel
  {
    const auto image = relievoTest::CaptureShadow(stage, 0);
    RELIEVO_CHECK(stage.GetShadows()->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT);
    const float* drawn =
      vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
    long long dark = 0;
    long long falseLight = 0;
    long long falseShadow = 0;
    for (int i = 0; i < Side * Side; ++i)
    {
      const double share = truth(Pixel * (i % Side - Side / 2), Pixel * (i / Side - Side / 2));
      dark += share == 0. ? 1 : 0;
      falseLight += share == 0. && drawn[i] > 0.f ? 1 : 0;
      falseShadow += share == 1. && drawn[i] < 1.f ? 1 : 0;
    }
    const std::string which = what + ", frame " + std::to_string(frame);
    RELIEVO_CHECK_THAT(dark >= leastDark, which + ": dark pixels " + std::to_string(dark));
    RELIEVO_CHECK_AT_MOST(falseLight, 0, which + ": pixels that light gets through to");
    RELIEVO_CHECK_AT_MOST(falseShadow, 0, which + ": pixels in false shadow");
  }
}

// The ground from above, under the mesh, a pixel for each half of a cell's shadow.
void Set(ShadowStage& stage, vtkPolyData* mesh)
{
  const auto ground = relievoTest::MakePolygons(
    { { -Edge, 0., Edge }, { Edge, 0., Edge }, { Edge, 0., -Edge }, { -Edge, 0., -Edge } });
  ground->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  relievoTest::AddActor(stage.Renderer, ground);
  relievoTest::AddActor(stage.Renderer, mesh);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0., 2., 0.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 0., 1.); // and x to the left, which the truths do not tell from the right
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Side * Pixel);
  camera->SetClippingRange(1., 5.);
  stage.GetShadows()->SetMethodToExact();
}

// A lamp inside: all rays cross the mesh once.
void TestInside(Relief relief, double cone, const std::string& what)
{
  {
    ShadowStage stage(Side, Side);
    Set(stage, MakeClosed(relief, 0, 0));
    stage.AddLamp({ 0., Middle, 0. }, { 0., 0., 0. }, cone);
    Check(
      stage, [](double, double) { return 0.; }, Side * Side, what + " inside");
  }
  // Without eight cells in the middle, light gets through there and nowhere else.
  ShadowStage stage(Side, Side);
  Set(stage, MakeClosed(relief, Cells / 2 - 4, Cells / 2 + 4));
  stage.AddLamp({ 0., Middle, 0. }, { 0., 0., 0. }, cone);
  Check(
    stage,
    [](double x, double z) {
      const double off = std::max(std::abs(x), std::abs(z)) / Pixel - 8.;
      return std::abs(off) < 0.5 ? -1. : off < 0. ? 1. : 0.;
    },
    Side * Side - 17 * 17, what + " inside, with a hole");
}

// A lamp above: the shadow's rim is that of the upper side, and rays meet its corners.
void TestAbove(double cone, const std::string& what)
{
  ShadowStage stage(Side, Side);
  Set(stage, MakeClosed(Flat, 0, 0));
  stage.AddLamp({ 0., 10., 0. }, { 0., 0., 0. }, cone);
  Check(
    stage,
    [](double x, double z) {
      const double off = std::max(std::abs(x), std::abs(z)) / Pixel - Cells / 2;
      return std::abs(off) < 0.5 ? -1. : off < 0. ? 0. : 1.;
    },
    (Cells - 1) * (Cells - 1), what + " above");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowWatertight)
{
  relievoTest::Session session;
  TestInside(Flat, 60., "spot");
  TestInside(Bumpy, 60., "spot, bumpy");
  TestInside(Flat, 90., "point light");
  TestInside(Bumpy, 90., "point light, bumpy");
  TestAbove(35., "spot");
  TestAbove(90., "point light");
  return session.Result();
}
}
