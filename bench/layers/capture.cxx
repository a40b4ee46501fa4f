// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time to get depth, normal and cell of every pixel into arrays, against VTK's method: z by
// vtkWindowToImageFilter and cells by vtkHardwareSelector (and no normals).
#include "RelievoBench.h"

#include "FrameBench.h"
#include "Table.h"

#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

constexpr int Width = 1920;
constexpr int Height = 1080;
constexpr int Rounds = 15;

const std::vector<std::string> Layers = { "depth", "normal", "cell" };

vtkSmartPointer<vtkImageData> Capture(vtkRelievoLayerSource* source)
{
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> CaptureZ(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetInputBufferTypeToZBuffer();
  filter->Update();
  return filter->GetOutput();
}

// Cells of all pixels, -1 in the background. Read from the raw buffers: the selector's own
// GetPixelInformation, called per pixel, takes longer.
std::vector<int> CaptureCells(vtkRenderer* renderer)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Width - 1, Height - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  std::vector<int> cells;
  if (!selector->CaptureBuffers())
  {
    return cells;
  }
  const unsigned char* actor = selector->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
  const unsigned char* low = selector->GetPixelBuffer(vtkHardwareSelector::CELL_ID_LOW24);
  cells.resize(static_cast<std::size_t>(Width) * Height);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const unsigned char* a = actor + 3 * i;
    const unsigned char* c = low + 3 * i;
    // Actors are numbered from 1, cells from 0.
    cells[i] = (a[0] | a[1] | a[2]) != 0 ? c[0] | (c[1] << 8) | (c[2] << 16) : -1;
  }
  selector->ClearBuffers();
  return cells;
}

// Share of the pixels in which both methods give different cells.
double Differing(vtkImageData* ours, const std::vector<int>& theirs)
{
  vtkDataArray* cells = ours->GetPointData()->GetArray("cell");
  std::size_t differing = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i)
  {
    differing += static_cast<int>(cells->GetComponent(static_cast<vtkIdType>(i), 0)) != theirs[i];
  }
  return static_cast<double>(differing) / static_cast<double>(theirs.size());
}

// Times of one scene: the row's fields after the scene's name.
bool Measure(const std::string& name, Table& table)
{
  const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
  if (!mesh)
  {
    return false;
  }
  const SceneWindow plain(mesh, Width, Height);
  const SceneWindow peer(mesh, Width, Height);
  const SceneWindow whole(mesh, Width, Height);
  const SceneWindow split(mesh, Width, Height);

  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(whole.Scene.Renderer);
  for (const std::string& layer : Layers)
  {
    source->AddLayer(layer);
  }
  // The steps of the source, one by one.
  vtkRelievoPass* pass = vtkRelievoPass::Attach(split.Scene.Renderer);
  for (const std::string& layer : Layers)
  {
    pass->RequestLayer(layer);
  }
  pass->SetLayersOnly(true);
  vtkNew<vtkImageData> image;

  std::vector<Timed> ways;
  ways.push_back(plain.Frame());
  ways.push_back({ [&] { CaptureZ(peer.Window); }, {} });
  ways.push_back({ [&] { CaptureCells(peer.Scene.Renderer); }, {} });
  ways.push_back({ [&] { Capture(source); }, {} });
  const auto draw = [&] {
    split.Window->Start();
    split.Scene.Renderer->Render();
    split.Window->WaitForCompletion();
  };
  ways.push_back({ draw, {} });
  for (const std::string& layer : Layers)
  {
    ways.push_back({ [&] { pass->ReadLayer(layer, image); },
      [&] {
        draw();
        image->Initialize();
      } });
  }
  std::vector<Timing> processors;
  const std::vector<Timing> times = TimeInTurn(ways, Rounds, processors);

  const auto ours = Capture(source);
  const double differing = Differing(ours, CaptureCells(peer.Scene.Renderer));
  // The ratio of z and cells together, by round.
  const auto ratioOf = [](const std::vector<Timing>& all) {
    Timing both;
    for (std::size_t i = 0; i < all[1].Seconds.size(); ++i)
    {
      both.Seconds.push_back(all[1].Seconds[i] + all[2].Seconds[i]);
    }
    return PairOf(both, all[3]);
  };
  const auto ratio = ratioOf(times);
  const auto ofProcessor = ratioOf(processors);
  const auto milliseconds = [](const Timing& timing) { return Number(1e3 * timing.Median(), 3); };
  std::cout << name << ": " << ratio.ToString("VTK's z and cells", "Relievo's depth, normal, cell")
            << "; z " << milliseconds(times[1]) << " ms, cells " << milliseconds(times[2])
            << " ms; plain frame " << milliseconds(times[0]) << " ms; Relievo: draw "
            << milliseconds(times[4]) << " ms, read alone depth " << milliseconds(times[5])
            << " ms, normal " << milliseconds(times[6]) << " ms, cell " << milliseconds(times[7])
            << " ms; of processor time " << milliseconds(processors[3]) << " ms, ratio "
            << Number(ofProcessor.Ratio(), 3) << " +- " << Number(ofProcessor.RatioSpread(), 1)
            << "; cells differ in " << Number(100. * differing, 2) << " % of the pixels"
            << std::endl;
  table.AddRow({ name, Number(ratio.Ratio(), 3), Number(ratio.RatioSpread(), 1),
    milliseconds(times[0]), milliseconds(times[1]), milliseconds(times[2]), milliseconds(times[3]),
    milliseconds(times[4]), milliseconds(times[5]), milliseconds(times[6]), milliseconds(times[7]),
    milliseconds(processors[3]), Number(ofProcessor.Ratio(), 3),
    Number(ofProcessor.RatioSpread(), 1), Number(differing, 2), Number(LoadAverage(), 2) });
  vtkRelievoPass::Detach(split.Scene.Renderer);
  return true;
}
}

//------------------------------------------------------------------------------
int RelievoBenchCapture(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table(
    { "scene", "VTK / Relievo", "+-", "plain frame ms", "VTK z ms", "VTK cells ms", "Relievo ms",
      "draw ms", "read depth ms", "read normal ms", "read cell ms", "Relievo processor ms",
      "VTK / Relievo processor", "processor +-", "pixels with another cell", "load" });
  for (const char* name : { "bunny", "motorBike" })
  {
    if (!Measure(name, table))
    {
      return 1;
    }
  }
  return table.WriteCsv(outDir + "/capture.csv") ? 0 : 1;
}
