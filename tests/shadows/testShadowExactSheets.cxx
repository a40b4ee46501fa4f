// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of sheets that are finely cut, bent within a few pixels, or close to each other.
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowExactSheets
{
namespace
{
using relievoTest::ShadowStage;

const float* Visibility(vtkImageData* image)
{
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
}

// A square sheet of cells x cells quads around the y axis, at the height of each corner.
template <typename Height>
vtkSmartPointer<vtkPolyData> Sheet(int cells, double width, const Height& height)
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      points.emplace_back(
        width * i / cells - width / 2., height(i, j), width * j / cells - width / 2.);
    }
  }
  auto mesh = relievoTest::MakePolygons(points);
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const vtkIdType p = i * (cells + 1) + j;
      mesh->GetPolys()->InsertNextCell({ p, p + 1, p + cells + 2, p + cells + 1 });
    }
  }
  return mesh;
}

// A finely cut sheet over all that is seen: no ray slips through between its triangles.
void TestWatertight()
{
  ShadowStage stage;
  stage.AddGround();
  const auto mesh =
    Sheet(40, 16., [](int i, int j) { return 6. + 0.3 * std::sin(i * 7.) * std::cos(j * 3.); });
  relievoTest::AddActor(stage.Renderer, mesh);
  stage.AddSun(0., 5., 0.); // right through the lattice's edges
  stage.GetShadows()->SetMethodToExact();
  double range[2];
  const auto image = relievoTest::CaptureShadow(stage, 0);
  long long lit = 0;
  const auto truth = relievoTest::TraceStage(stage, 0);
  for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
  {
    lit += truth.Verdicts[i] != relievoTest::ShadowTruth::Unjudged && Visibility(image)[i] > 0.f;
  }
  image->GetPointData()->GetArray("shadow_0")->GetRange(range);
  RELIEVO_CHECK_THAT(range[0] == 0., "watertight: nothing is dark");
  RELIEVO_CHECK_AT_MOST(lit, 0, "watertight: pixels that a ray slips through to");
}

// Stars: one version of VTK draws them as fans, another clips their ears.
void TestPolygons()
{
  ShadowStage stage;
  stage.AddGround();
  std::vector<glm::dvec3> points;
  for (int star = 0; star < 9; ++star)
  {
    const glm::dvec3 middle(1.6 * (star % 3) - 1.6, 1. + 0.1 * star, 1.6 * (star / 3) - 1.6);
    for (int i = 0; i < 10; ++i)
    {
      const double angle = 0.2 * glm::pi<double>() * i + 0.3 * star;
      points.push_back(
        middle + (i % 2 ? 0.25 : 0.7) * glm::dvec3(std::cos(angle), 0.2, std::sin(angle)));
    }
  }
  const auto mesh = relievoTest::MakePolygons(points);
  for (vtkIdType star = 0; star < 9; ++star)
  {
    mesh->GetPolys()->InsertNextCell(10);
    for (vtkIdType i = 0; i < 10; ++i)
    {
      mesh->GetPolys()->InsertCellPoint(10 * star + (i + star) % 10);
    }
  }
  relievoTest::AddActor(stage.Renderer, mesh);
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  const auto image = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK(stage.GetShadows()->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT);
  const relievoTest::ShadowErrors errors =
    relievoTest::CompareShadow(relievoTest::TraceStage(stage, 0), Visibility(image));
  RELIEVO_CHECK_THAT(errors.Dark > 500, "polygons: " + errors.ToString());
  // A pixel on a star's own edge may show another surface.
  RELIEVO_CHECK_AT_MOST(
    errors.FalseShadow + errors.FalseLight, 1, "polygons: " + errors.ToString());
}

long long CountUnlike(vtkImageData* first, vtkImageData* second)
{
  long long unlike = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    unlike += Visibility(first)[i] != Visibility(second)[i] ? 1 : 0;
  }
  return unlike;
}

// Bumps of a few pixels, to the rims of pictures whose last tiles are rows and columns of pixels:
// verdicts by tiles are those that each fragment of the mesh finds by itself in the first frame.
void TestBumps()
{
  for (const auto& size : { std::array<int, 2>{ 241, 177 }, std::array<int, 2>{ 121, 240 },
         std::array<int, 2>{ 97, 97 } })
  {
    ShadowStage stage(size[0], size[1]);
    const auto mesh =
      Sheet(300, 18., [](int i, int j) { return 0.06 * std::sin(i * 1.7) * std::cos(j * 1.1); });
    relievoTest::AddActor(stage.Renderer, mesh);
    stage.Renderer->GetActiveCamera()->SetPosition(0.5, 6., 3.);
    stage.AddSun(-4., 2., -1.);
    stage.GetShadows()->SetMethodToExact();
    const auto first = relievoTest::CaptureShadow(stage, 0);
    relievoTest::CaptureShadow(stage, 0);
    const auto kept = relievoTest::CaptureShadow(stage, 0);
    RELIEVO_CHECK_AT_MOST(CountUnlike(first, kept), 0,
      "bumps, " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + ": pixels unlike");
    relievoTest::CheckShadow(stage, 0, 1e-3, "bumps"); // edges everywhere, at 1/256 of a pixel
  }
}

// Sheets that a depth buffer of 24 bits can hardly tell apart: the verdicts that are kept are those
// of the sheet that the picture shows, as each fragment finds them by itself in the first frame,
// but for a pixel in which the two fight.
void TestCoarseDepth()
{
  ShadowStage stage;
  stage.AddThings();
  for (int i = 0; i < 2; ++i)
  {
    const auto sheet = stage.AddGround();
    sheet->SetPosition(0., 0.02 * (i + 1), 0.);
    sheet->SetScale(0.8 - 0.2 * i, 1., 0.8);
    sheet->RotateZ(0.1 * i);
  }
  stage.AddSun(-3., 4., -2.);
  stage.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 1e3);
  stage.GetShadows()->SetMethodToExact();
  const auto first = relievoTest::CaptureShadow(stage, 0);
  relievoTest::CaptureShadow(stage, 0);
  const auto kept = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK_AT_MOST(CountUnlike(first, kept), 1, "coarse depth: pixels unlike the first's");
}

// Surfaces that VTK moves in depth, each by its own offset: each pixel's verdict belongs to its
// visible surface.
void TestOffset()
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  ShadowStage stage;
  stage.AddThings();
  const auto sheet = stage.AddGround();
  sheet->SetPosition(0., 1e-6, 0.);
  sheet->SetScale(0.5, 1., 0.5);
  sheet->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0., -30.);
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  const auto first = relievoTest::CaptureShadow(stage, 0);
  relievoTest::CaptureShadow(stage, 0);
  const auto kept = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK_AT_MOST(CountUnlike(first, kept), 0, "offset: pixels unlike the first's");
  relievoTest::CheckShadow(stage, 0, 2e-5, "offset");
  vtkMapper::SetResolveCoincidentTopologyToOff();
}

// A sheet over the ground with a texture of numbers, whose table leaves half of it out: its shadow
// is that of VTK's picture, which no ray can trace.
void TestTableTexture()
{
  for (const bool leavesOut : { true, false })
  {
    ShadowStage stage;
    stage.AddGround();
    vtkNew<vtkPlaneSource> plane; // has texture coordinates
    plane->SetOrigin(-1.5, 1.5, -1.5);
    plane->SetPoint1(1.5, 1.5, -1.5);
    plane->SetPoint2(-1.5, 1.5, 1.5);
    plane->Update();
    const auto sheet = relievoTest::AddActor(stage.Renderer, plane->GetOutput());
    vtkNew<vtkImageData> numbers;
    numbers->SetDimensions(16, 16, 1);
    numbers->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 256; ++i)
    {
      static_cast<unsigned char*>(numbers->GetScalarPointer())[i] = i % 16 < 8 ? 0 : 255;
    }
    vtkNew<vtkLookupTable> table;
    table->SetRange(0., 255.);
    table->SetNumberOfTableValues(2);
    table->SetTableValue(0, 1., 1., 1., leavesOut ? 0. : 1.);
    table->SetTableValue(1, 1., 0.5, 0.2, 1.);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(numbers);
    texture->SetColorModeToMapScalars();
    texture->SetLookupTable(table);
    sheet->SetTexture(texture);
    stage.GetShadows()->SetPropCasts(sheet, vtkRelievoShadowStage::CASTS_ALWAYS);
    stage.AddSun(0.01, 5., 0.02);
    stage.GetShadows()->SetMethodToExact();
    const auto image = relievoTest::CaptureShadow(stage, 0);
    long long dark = 0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      dark += Visibility(image)[i] == 0.f ? 1 : 0;
    }
    const std::string report = stage.GetFrame()->GetFrameReport();
    const bool followed = report.find("of 2 casters") != std::string::npos;
    RELIEVO_CHECK_THAT(followed != leavesOut, "a texture's table: " + report);
    std::cout << "table: " << dark << " pixels dark\n";
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowExactSheets)
{
  relievoTest::Session session;
  TestWatertight();
  TestPolygons();
  TestBumps();
  TestCoarseDepth();
  TestOffset();
  TestTableTexture();
  return session.Result();
}
}
