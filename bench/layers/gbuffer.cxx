// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of layers per frame: ratios to the plain frame of the same scene, drawn in turn in one
// process. The peer is vtkSSAOPass, which makes its own G-buffer (positions and normals), with one
// sample per pixel.
#include "RelievoBench.h"

#include "FrameBench.h"
#include "Table.h"

#include <vtkNew.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>

#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

struct Size
{
  int Width;
  int Height;
};
const Size Sizes[] = { { 600, 600 }, { 800, 600 }, { 1920, 1080 } };
constexpr int Rounds = 21;

// A method of drawing the frame; vtkRelievoPass makes the layers.
struct Way
{
  const char* Name;
  std::vector<std::string> Layers;
  std::function<void(vtkRenderer*)> SetUp;
};

void Attach(vtkRenderer* renderer)
{
  vtkRelievoPass::Attach(renderer);
}

void UsePeer(vtkRenderer* renderer)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> peer;
  peer->SetKernelSize(1);
  peer->SetDelegatePass(steps);
  renderer->SetPass(peer);
}

const Way Ways[] = {
  { "plain", {}, nullptr },
  { "attached, nothing asked", {}, Attach },
  { "depth", { "depth" }, Attach },
  { "normal + depth", { "depth", "normal" }, Attach },
  { "normal + depth + albedo + ids", { "depth", "normal", "albedo", "actor", "cell" }, Attach },
  { "the same + geometric normal",
    { "depth", "normal", "geometric_normal", "albedo", "actor", "cell" }, Attach },
  { "vtkSSAOPass, kernel 1", {}, UsePeer },
};

// One scene at one size: a ratio per method.
bool Measure(const std::string& name, vtkPolyData* mesh, const Size& size, Table& table)
{
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<Timed> frames;
  for (const Way& way : Ways)
  {
    windows.emplace_back(new SceneWindow(mesh, size.Width, size.Height));
    vtkRenderer* renderer = windows.back()->Scene.Renderer;
    if (way.SetUp)
    {
      way.SetUp(renderer);
    }
    auto* pass = vtkRelievoPass::SafeDownCast(renderer->GetPass());
    for (const std::string& layer : way.Layers)
    {
      pass->RequestLayer(layer);
    }
    frames.push_back(windows.back()->Frame());
  }
  const std::vector<Timing> times = TimeInTurn(frames, Rounds);
  const std::string pixels = std::to_string(size.Width) + "x" + std::to_string(size.Height);
  std::cout << name << ", " << pixels << ", plain frame " << Number(1e3 * times[0].Median(), 3)
            << " ms; times a plain frame:" << std::endl;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    auto* pass = vtkRelievoPass::SafeDownCast(windows[i]->Scene.Renderer->GetPass());
    if (pass && !Ways[i].Layers.empty() && !pass->GetLayersStage()->GetShared())
    {
      std::cerr << "relievo: bench: " << Ways[i].Name
                << " was not written in the shared geometry pass: " << pass->GetFrameReport()
                << "\n";
      return false;
    }
    const auto pair = PairOf(times[i], times[0]);
    std::cout << "  " << Ways[i].Name << ": " << Number(pair.Ratio(), 3) << " +- "
              << Number(pair.RatioSpread(), 1) << std::endl;
    table.AddRow({ name, pixels, Ways[i].Name, Number(pair.Ratio(), 4),
      Number(pair.RatioSpread(), 2), Number(1e3 * times[i].Median(), 4),
      Number(
        pass ? static_cast<double>(pass->GetBytesHeld()) / (1. * size.Width * size.Height) : 0., 3),
      Number(LoadAverage(), 2) });
  }
  return true;
}
}

//------------------------------------------------------------------------------
int RelievoBenchGBuffer(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "pixels", "frame", "times a plain frame", "+-", "milliseconds",
    "bytes per pixel", "load" });
  for (const std::string& name : relievoTest::ReferenceMeshes())
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const Size& size : Sizes)
    {
      if (!Measure(name, mesh, size, table))
      {
        return 1;
      }
    }
  }
  return table.WriteCsv(outDir + "/gbuffer.csv") ? 0 : 1;
}
