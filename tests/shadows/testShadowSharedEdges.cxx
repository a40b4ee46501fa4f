// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays through the edges that triangles share, by design of the scene: translucent ones count once
// there, on the GPU and on the CPU, and between opaque ones nothing slips through.
#include "vtkRelievoCasterRays.h" // before all of GLM, whose functions it has of its own

#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace testShadowSharedEdges
{
namespace
{
using relievoTest::ShadowStage;

constexpr double Low = -1.5;
constexpr double High = 1.5;
constexpr double Height = 4.;

// A square of cells x cells quads, two triangles each.
vtkSmartPointer<vtkPolyData> MakePane(int cells)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(Low, Height, Low);
  plane->SetPoint1(High, Height, Low);
  plane->SetPoint2(Low, Height, High);
  plane->SetResolution(cells, cells);
  plane->Update();
  return plane->GetOutput();
}

// From right above, by an odd number of pixels: the middle row and column, and the diagonals, see
// places right below edges.
void TestPane(int cells, double opacity, const std::string& what)
{
  constexpr int Side = 601;
  ShadowStage stage(Side, Side);
  stage.AddGround();
  const auto pane = relievoTest::AddActor(stage.Renderer, MakePane(cells));
  pane->GetProperty()->SetOpacity(opacity);
  stage.GetShadows()->SetPropCasts(pane, vtkRelievoShadowStage::CASTS_ALWAYS);
  stage.AddSun(0., 5., 0.);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0., 2., 0.); // below the pane
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 0., -1.);
  camera->SetViewAngle(90.);
  camera->SetClippingRange(1., 5.);
  stage.GetShadows()->SetMethodToExact();
  for (int frame = 0; frame < 2; ++frame) // of each fragment's rays, and found pixel by pixel
  {
    const auto image = relievoTest::CaptureShadow(stage, 0);
    const float* shares =
      vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
    long long below = 0;
    long long mismatches = 0;
    for (int i = 0; i < Side * Side; ++i)
    {
      const double x = 4. * (i % Side - Side / 2) / Side;
      const double z = 4. * (i / Side - Side / 2) / Side;
      const double off = std::max(std::abs(x), std::abs(z)) - High;
      const double share = off < 0. ? 1. - opacity : 1.;
      below += off < 0. ? 1 : 0;
      mismatches += std::abs(off) > 1e-4 && std::abs(shares[i] - share) > 0.51 / 255. ? 1 : 0;
    }
    RELIEVO_CHECK_THAT(below > 200000, what + ": the pane is over the picture");
    RELIEVO_CHECK_AT_MOST(
      mismatches, 0, what + ", frame " + std::to_string(frame) + ": pixels of another share");
  }
}

// Rays of the CPU from a lattice of places to a sun and to a lamp, right through corners and edges.
void TestRays(double opacity, bool turned)
{
  const auto mesh = MakePane(8);
  vtkRelievoSurface surface;
  surface.Caster.Mesh = mesh;
  surface.Caster.Opacity = opacity;
  if (turned)
  {
    surface.Caster.MeshToWorld[0] = glm::dvec4(0., 0., -1., 0.);
    surface.Caster.MeshToWorld[2] = glm::dvec4(1., 0., 0., 0.);
  }
  vtkRelievoCasterRays rays;
  rays.SetSurfaces({ surface });
  constexpr int Steps = 48; // places over corners, diagonals, and none of them
  long long mismatches = 0;
  for (int i = 1; i < Steps; ++i)
  {
    for (int j = 1; j < Steps; ++j)
    {
      const glm::dvec3 over(Low + (High - Low) * i / Steps, Height, Low + (High - Low) * j / Steps);
      const glm::dvec3 lamp(0.25, 2. * Height, -0.5);
      for (const glm::dvec3& ray : { glm::dvec3(0., 1., 0.), lamp - over })
      {
        const double passed =
          rays.Pass(over - ray - rays.GetCenter(), ray, 2., vtkRelievoCasterRays::Hit(), 1e-6);
        mismatches += passed != 1. - opacity ? 1 : 0;
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "rays on the CPU that pass another share");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowSharedEdges)
{
  relievoTest::Session session;
  TestPane(2, 0.5, "pane");
  TestPane(6, 0.5, "fine pane");
  TestPane(2, 1., "opaque");
  for (const double opacity : { 1., 0.5 })
  {
    TestRays(opacity, false);
    TestRays(opacity, true);
  }
  return session.Result();
}
}
