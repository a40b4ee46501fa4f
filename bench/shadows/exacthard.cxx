// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dense edges: share of errors of exact shadows, with and without the pixels in which OpenGL's grid
// decides which side of an edge is visible, and the expected share. Truth is Embree on the same
// triangles.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "CodedScenes.h"
#include "EmbreeScene.h"
#include "ShadowErrors.h"
#include "ShadowVerdicts.h"
#include "Table.h"
#include "View.h"
#include "Window.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <iostream>
#include <string>

namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;

const ShadowLight Lights[] = {
  { "sun", SceneLight::Sun, 0. },
  { "sun at 10 degrees", SceneLight::Sun, 10. },
  { "point", SceneLight::Point, 0. },
};

// At the middle of the scenes, world units.
constexpr double ViewHeight = 4.;

void Measure(const std::string& name, vtkPolyData* mesh, const ShadowLight& light,
  const ExactHardSizes& sizes, Table& table)
{
  const auto scene = MakeShadowScene(name, mesh, light);
  const auto window = relievoTest::MakeWindow(sizes.Width, sizes.Height, scene.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  frame->ShadowsOn();
  shadows->SetMethodToExact();
  window->Render();
  const double expected =
    shadows->EstimateWrongShareInView(vtkRelievoShadowStage::METHOD_EXACT, 2048);
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(scene.Renderer);
  source->AddLayer("shadow_0");
  source->Update();
  const float* drawn =
    vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("shadow_0"))
      ->GetPointer(0);
  const auto rays = scene.MakeTruth();
  const auto view = rays->Trace(relievoTest::View(scene.Renderer));
  // Two steps of OpenGL's grid of 1/256 pixel, because surfaces are seen obliquely.
  const double tie = 2. / 256. * ViewHeight / sizes.Height;
  const auto all =
    relievoTest::CompareShadow(relievoTest::TraceShadow(*rays, view, scene.Light, 0.), drawn);
  const auto sure = relievoTest::CompareShadow(
    relievoTest::WithoutEdges(relievoTest::TraceShadow(*rays, view, scene.Light, tie), view),
    drawn);
  table.AddRow(
    { name, light.Name, std::to_string(all.Compared), std::to_string(all.Compared - sure.Compared),
      Number(100. * all.Wrong()), Number(100. * sure.Wrong()), Number(100. * expected) });
  std::cout << name << ", " << light.Name << ": " << Number(100. * all.Wrong(), 3) << " % wrong, "
            << Number(100. * sure.Wrong(), 3) << " % without ties, " << Number(100. * expected, 3)
            << " % expected" << std::endl;
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchExactHard(const std::string& outDir, const ExactHardSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table(
    { "scene", "light", "pixels", "ties", "wrong %", "wrong without ties %", "expected %" });
  for (const std::string& name : sizes.Scenes)
  {
    const auto mesh = ShadowSceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const ShadowLight& light : Lights)
    {
      Measure(name, mesh, light, sizes, table);
    }
  }
  return table.WriteCsv(outDir + "/exact-hard.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchExactHard(const std::string& outDir)
{
  return relievoBench::BenchExactHard(outDir, {});
}
