// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shadow planner's choices for a tolerance, over random scenes, lights, cameras and tolerances:
// how often the share of errors, against Embree, is within the tolerance.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "CodedScenes.h"
#include "EmbreeScene.h"
#include "MadeMeshes.h"
#include "ShadowErrors.h"
#include "Table.h"
#include "View.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Lots;
using relievoTest::SceneLight;

constexpr int Tolerances = 5; // per scene
constexpr double Least = 5e-5;
constexpr double Most = 4e-3;
constexpr double Pi = 3.14159265358979323846;

const ShadowLight Lights[] = {
  { "sun", SceneLight::Sun, 0. },
  { "spot", SceneLight::Spot, 0. },
  { "point", SceneLight::Point, 0. },
};

// On a sphere around the scene's middle, `low` to `high` degrees above the ground.
void GetPlace(Lots& lots, double distance, double low, double high, double place[3])
{
  const double turn = lots.Between(0., 2. * Pi);
  const double up = lots.Between(low, high) * Pi / 180.;
  place[0] = distance * std::cos(up) * std::cos(turn);
  place[1] = distance * std::sin(up) + 0.5;
  place[2] = distance * std::cos(up) * std::sin(turn);
}

// Returns the shares of errors divided by the tolerances.
std::vector<double> Measure(int number, const PlannerCaseSizes& sizes, Lots& lots, Table& table)
{
  const ShadowLight& kind = Lights[number % 3];
  const auto scene = MakeShadowScene("", relievoTest::MakeThings(lots), kind);
  double place[3];
  GetPlace(lots, 6., 8., 80., place);
  scene.Light->SetPosition(place);
  GetPlace(lots, lots.Between(5., 9.), 8., 70., place);
  scene.Renderer->GetActiveCamera()->SetPosition(place);
  const auto window = relievoTest::MakeWindow(sizes.Width, sizes.Height, scene.Renderer);
  scene.Renderer->ResetCameraClippingRange();
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  frame->ShadowsOn();
  const auto rays = scene.MakeTruth();
  const auto truth =
    relievoTest::TraceShadow(*rays, rays->Trace(relievoTest::View(scene.Renderer)), scene.Light);
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(scene.Renderer);
  source->AddLayer("shadow_0");
  std::vector<double> shares;
  for (int i = 0; i < Tolerances; ++i)
  {
    const double tolerance = Least * std::pow(Most / Least, lots.Between(0., 1.));
    shadows->SetTolerance(tolerance);
    window->Render();
    source->Update();
    const auto errors = relievoTest::CompareShadow(truth,
      vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("shadow_0"))
        ->GetPointer(0));
    shares.push_back(errors.Wrong() / tolerance);
    const bool exact = shadows->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT;
    table.AddRow({ std::to_string(number), kind.Name, Number(100. * tolerance),
      exact                                                                ? "exact"
        : shadows->GetMethodUsed() == vtkRelievoShadowStage::METHOD_WARPED ? "warped"
                                                                           : "map",
      exact ? "" : std::to_string(shadows->GetMapSizeUsed()), Number(100. * errors.Wrong()),
      Number(shares.back()) });
  }
  return shares;
}

double PercentWithin(const std::vector<double>& shares, double most)
{
  const auto within =
    std::count_if(shares.begin(), shares.end(), [most](double share) { return share <= most; });
  return 100. * static_cast<double>(within) / static_cast<double>(shares.size());
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchPlannerCases(const std::string& outDir, const PlannerCaseSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "light", "tolerance %", "method", "map", "wrong %", "wrong / tolerance" });
  std::vector<double> shares;
  Lots lots(sizes.Seed);
  for (int i = 0; i < sizes.Scenes; ++i)
  {
    const std::vector<double> more = Measure(i, sizes, lots, table);
    shares.insert(shares.end(), more.begin(), more.end());
  }
  std::cout << shares.size() << " cases by lot, seed " << sizes.Seed << ": "
            << Number(PercentWithin(shares, 1.), 3) << " % within the tolerance, "
            << Number(PercentWithin(shares, 1.5), 3) << " % within 1.5 times, all within "
            << Number(*std::max_element(shares.begin(), shares.end()), 3) << " times" << std::endl;
  return table.WriteCsv(outDir + "/planner-cases.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchPlannerCases(const std::string& outDir)
{
  return relievoBench::BenchPlannerCases(outDir, {});
}
