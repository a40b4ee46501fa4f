// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 11: error of the visible share of an area light, against the number of samples that a
// capture accumulates. Truth is Embree on the same triangles, 1024 rays for each pixel in a
// penumbra.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "CodedScenes.h"
#include "EmbreeScene.h"
#include "SoftShadowTruth.h"
#include "Table.h"
#include "View.h"
#include "Window.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <chrono>
#include <iostream>
#include <string>

namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;

struct SizedLight
{
  ShadowLight Light;
  double Size; // degrees, or a radius; scenes are 6 wide, their lamps 6 away
  bool HasEdges;
};
const SizedLight Lights[] = {
  { { "sun", SceneLight::Sun, 0. }, 0.53, false },
  { { "spot", SceneLight::Spot, 0. }, 0.2, false },
  { { "point", SceneLight::Point, 0. }, 0.2, false },
  { { "point", SceneLight::Point, 0. }, 0.5, false },
  { { "point", SceneLight::Point, 0. }, 1., false },
  { { "point", SceneLight::Point, 0. }, 2., false },
  { { "rectangle", SceneLight::Spot, 0. }, 0., true },
};
const relievoTest::LightEdges Edges = { { 0.8, 0., 0. }, { 0., 0.1, 0.2 } };

const struct
{
  const char* Name;
  int Method;
} Methods[] = {
  { "map", vtkRelievoShadowStage::METHOD_MAP },
  { "exact", vtkRelievoShadowStage::METHOD_EXACT },
};

void MeasureLight(const std::string& name, vtkPolyData* mesh, const SizedLight& light,
  const SoftShadowSizes& sizes, Table& table)
{
  const auto scene = MakeShadowScene(name, mesh, light.Light);
  const auto window = relievoTest::MakeWindow(sizes.Width, sizes.Height, scene.Renderer);
  window->Render();
  const auto rays = scene.MakeTruth();
  const auto truth =
    relievoTest::TraceSoftShadow(*rays, rays->Trace(relievoTest::View(scene.Renderer)), scene.Light,
      light.Size, light.HasEdges ? &Edges : nullptr);
  vtkRelievoShadowStage* shadows = vtkRelievoPass::Attach(scene.Renderer)->GetShadowStage();
  shadows->SetLightSize(scene.Light, light.Size);
  if (light.HasEdges)
  {
    shadows->SetLightEdges(scene.Light, &Edges.First.x, &Edges.Second.x);
  }
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(scene.Renderer);
  source->AddLayer("shadow_0");
  for (const auto& method : Methods)
  {
    shadows->SetMethod(method.Method);
    for (const int samples : sizes.Samples)
    {
      shadows->SetSoftSamples(samples);
      const auto from = std::chrono::steady_clock::now();
      source->Update();
      const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - from;
      auto* shares =
        vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("shadow_0"));
      const auto errors = relievoTest::CompareSoftShadow(truth, shares->GetPointer(0));
      table.AddRow(
        { name, light.Light.Name, Number(light.Size), method.Name, std::to_string(samples),
          std::to_string(errors.Compared), std::to_string(errors.Penumbra), Number(errors.Rms),
          Number(errors.PenumbraRms), Number(errors.PenumbraMean), Number(took.count()) });
      std::cout << name << ", " << light.Light.Name << ", " << method.Name << ", " << samples
                << " samples: " << errors.ToString() << ", " << Number(took.count()) << " ms"
                << std::endl;
    }
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchSoftShadows(const std::string& outDir, const SoftShadowSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "light", "size", "method", "samples", "pixels", "penumbra pixels", "rms",
    "penumbra rms", "penumbra mean", "milliseconds" });
  for (const std::string& name : sizes.Scenes)
  {
    const auto mesh = ShadowSceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const SizedLight& light : Lights)
    {
      if (name == sizes.Scenes.front() || light.Light.Kind == SceneLight::Sun)
      {
        MeasureLight(name, mesh, light, sizes, table);
      }
    }
  }
  return table.WriteCsv(outDir + "/soft-shadows.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchSoftShadows(const std::string& outDir)
{
  return relievoBench::BenchSoftShadows(outDir, {});
}
