// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 5: false shadow on lit surfaces and leak of light into dark ones, by the bias of a shadow
// map, under a high, a low and a grazing sun.
//
// vtkRelievoShadowStage is drawn, and its pictures are compared with Embree. Beside it: a constant
// bias, the usual one, computed in double precision from a map of the same size, with and without
// the receiver's plane; and vtkShadowMapPass, which has no bias to set, as a point.
#include "RelievoBench.h"

#include "ShadowSimulation.h"
#include "ShadowVerdicts.h"
#include "Table.h"

#include <vtkLight.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;
using relievoTest::ShadowErrors;

constexpr int MapSize = 2048;
constexpr int Pixels = 600;
const double Biases[] = { 0., 0.25, 0.5, 1., 1.5, 2., 4., 8., 16. };
const char* const Scenes[] = { "bunny", "motorBike", SlabsScene };
const ShadowLight Suns[] = {
  { "45", SceneLight::Sun, 45. },
  { "10", SceneLight::Sun, 10. },
  { "3", SceneLight::Sun, 3. },
};

const char* const Drawn = "map";
const char* const SimulatedPlane = "receiver plane, computed";
const char* const SimulatedConstant = "constant, computed";
const char* const Peer = "vtkShadowMapPass";

struct Result
{
  std::string Scene;
  std::string Sun;
  std::string Method;
  double Bias;
  ShadowErrors Errors;

  double FalseShadow() const
  {
    return Percent(this->Errors.FalseShadow, this->Errors.Compared - this->Errors.Dark);
  }
  double Leak() const { return Percent(this->Errors.FalseLight, this->Errors.Dark); }
  double Wrong() const { return 100. * this->Errors.Wrong(); }
};

void Add(std::vector<Result>& results, const Result& result)
{
  results.push_back(result);
  std::cout << result.Scene << ", sun at " << result.Sun << " degrees, " << result.Method
            << ", bias " << result.Bias << ": " << result.Errors.ToString() << std::endl;
}

void Measure(
  const std::string& name, vtkPolyData* mesh, const ShadowLight& sun, std::vector<Result>& results)
{
  ShadowVerdicts verdicts(name, mesh, sun, Pixels, Pixels);
  vtkRenderer* renderer = verdicts.Scene.Renderer;
  UseShadowMap(renderer, MapSize);
  vtkRelievoShadowStage* pass = vtkRelievoPass::SafeDownCast(renderer->GetPass())->GetShadowStage();
  for (double bias : Biases)
  {
    pass->SetBias(bias);
    Add(results, { name, sun.Name, Drawn, bias, verdicts.MeasureAsItIs() });
  }
  UseNoShadows(verdicts.Window, renderer);
  UseShadowPeer(renderer, MapSize);
  Add(results, { name, sun.Name, Peer, 0., verdicts.MeasureAsItIs() });
  UseNoShadows(verdicts.Window, renderer);

  glm::dvec3 toSun;
  verdicts.Scene.Light->GetPosition(&toSun[0]);
  const ShadowSimulation simulation(*verdicts.Scene.MakeTruth(), verdicts.View, toSun, MapSize);
  for (const bool plane : { true, false })
  {
    for (double bias : Biases)
    {
      Add(results,
        { name, sun.Name, plane ? SimulatedPlane : SimulatedConstant, bias,
          relievoTest::CompareShadow(
            verdicts.Truth, simulation.Visibility(verdicts.View, bias, plane).data()) });
    }
  }
}

}

//------------------------------------------------------------------------------
int RelievoBenchBias(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  std::vector<Result> results;
  for (const char* name : Scenes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = ShadowSceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const ShadowLight& sun : Suns)
    {
      Measure(name, mesh, sun, results);
    }
  }
  Table table({ "scene", "sun, degrees", "method", "bias, texels", "pixels", "dark %", "wrong %",
    "false shadow % of lit", "leak % of dark", "left out, flipping" });
  for (const Result& r : results)
  {
    table.AddRow({ r.Scene, r.Sun, r.Method, r.Method == Peer ? std::string() : Number(r.Bias),
      std::to_string(r.Errors.Compared), Number(Percent(r.Errors.Dark, r.Errors.Compared)),
      Number(r.Wrong()), Number(r.FalseShadow()), Number(r.Leak()),
      std::to_string(r.Errors.Flipping) });
  }
  return table.WriteCsv(outDir + "/bias.csv") ? 0 : 1;
}
