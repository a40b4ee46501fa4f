// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 3: distance of a pixel's position from the surface, by the format stored in the G-buffer,
// against its bytes and the time of the frame that writes it.
//
// Truth is Embree on the same triangles, for pixels with a certain verdict. Formats offered by the
// passes are drawn and captured. Others are computed: the GPU's depth in 32-bit float, rounded
// further as in such a texture. The error of each format alone is that of the truth rounded in this
// way.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "EmbreeScene.h"
#include "FrameBench.h"
#include "PositionFormats.h"
#include "Statistics.h"
#include "Table.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderer.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::PixelTruth;
using relievoTest::Timed;
using relievoTest::Timing;
using relievoTest::TruthImage;
using relievoTest::View;

constexpr int Width = 800;
constexpr int Height = 600;

// OpenGL rounds corners to 1/256 pixel: nearer to an edge, the hit triangle is undetermined.
constexpr double Grid = 1. / 256.;

// The position of a pixel at a depth after storage in a texture.
struct Format
{
  double (*Depth)(double depth, const DepthRange& range);
  double (*World)(double coordinate);
  double (*Eye)(double coordinate);

  glm::dvec3 Through(const View& view, const relievoTest::Ray& ray, double depth) const
  {
    if (this->Depth)
    {
      return ray.At(this->Depth(depth, { view.Near, view.Far, view.Parallel }));
    }
    const glm::dvec3 world = ray.At(depth);
    if (this->World)
    {
      return glm::dvec3(this->World(world.x), this->World(world.y), this->World(world.z));
    }
    const glm::dvec3 offset = world - view.Eye;
    return view.Eye + this->Eye(glm::dot(offset, view.Right)) * view.Right +
      this->Eye(glm::dot(offset, view.Up)) * view.Up +
      this->Eye(glm::dot(offset, view.Forward)) * view.Forward;
  }
};

void NormalFormat(vtkRelievoLayersStage* gbuffer, int format)
{
  gbuffer->SetNormalFormat(format);
}

void DepthFormat(vtkRelievoLayersStage* gbuffer, int format)
{
  gbuffer->SetDepthFormat(format);
}

void DepthAlone(vtkRelievoLayersStage* gbuffer, int)
{
  gbuffer->RefineDepthOff();
}

void Default(vtkRelievoLayersStage*, int) {}

// Bytes are those of a texture of the format. The timed frame requests `Layer`, set up by
// SetUp(gbuffer, Setting); if the passes lack the format, a layer with as many bytes.
struct Method
{
  const char* Name; // with a star: not offered
  int Bytes;
  Format Stored;
  const char* Layer;
  void (*SetUp)(vtkRelievoLayersStage*, int);
  int Setting;
  const char* StandIn;

  bool IsOffered() const { return *this->StandIn == 0; }
};

using Pass = vtkRelievoLayersStage;
const Method Methods[] = {
  { "depth R16F", 2, { ThroughDepth16F, nullptr, nullptr }, "position", DepthFormat,
    Pass::DEPTH_16F, "" },
  { "window z, 24 bits", 3, { ThroughWindowZ24, nullptr, nullptr }, "position", DepthFormat,
    Pass::DEPTH_WINDOW_Z24, "" },
  { "window z, 32F *", 4, { ThroughWindowZ32F, nullptr, nullptr }, "position", DepthFormat,
    Pass::DEPTH_REVERSED_32F, "reversed z, 32F" },
  { "reversed z, 32F", 4, { ThroughReversed32F, nullptr, nullptr }, "position", DepthFormat,
    Pass::DEPTH_REVERSED_32F, "" },
  { "depth R32F", 4, { ThroughDepth32F, nullptr, nullptr }, "position", DepthAlone, 0, "" },
  { "depth R32F + id, refined", 8, { ThroughDepth32F, nullptr, nullptr }, "position", Default, 0,
    "" },
  { "world RGBA16F *", 8, { nullptr, ThroughHalf, nullptr }, "normal", NormalFormat,
    Pass::NORMAL_FLOAT16, "normal as 3 half" },
  { "world RGBA32F *", 16, { nullptr, ThroughFloat, nullptr }, "normal", NormalFormat,
    Pass::NORMAL_FLOAT32, "normal as 3 float" },
  { "eye space RGBA32F *", 16, { nullptr, nullptr, ThroughFloat }, "normal", NormalFormat,
    Pass::NORMAL_FLOAT32, "normal as 3 float" },
};

struct Case
{
  const char* Projection;
  const char* Place;
  double ParallelScale; // 0: perspective
  glm::dvec3 Offset;    // of the whole scene
};

const Case Cases[] = {
  { "perspective", "origin", 0., { 0., 0., 0. } },
  { "perspective", "(5e5, 5e6, 0)", 0., { 5e5, 5e6, 0. } },
  { "parallel", "origin", 1.6, { 0., 0., 0. } },
  { "parallel", "(5e5, 5e6, 0)", 1.6, { 5e5, 5e6, 0. } },
};

void Move(const relievoTest::ReferenceScene& scene, const Case& c)
{
  relievoTest::SetReferenceCamera(scene.Renderer);
  for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
  {
    actor->SetPosition(c.Offset.x, c.Offset.y, c.Offset.z);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  glm::dvec3 at;
  camera->GetPosition(&at[0]);
  at += c.Offset;
  camera->SetPosition(&at[0]);
  camera->GetFocalPoint(&at[0]);
  at += c.Offset;
  camera->SetFocalPoint(&at[0]);
  camera->SetParallelProjection(c.ParallelScale > 0.);
  camera->SetParallelScale(c.ParallelScale > 0. ? c.ParallelScale : 1.);
  camera->SetClippingRange(2., 14.); // VTK's own range follows the camera's movement
}

// Draws a layer.
vtkSmartPointer<vtkDataArray> Draw(
  vtkRenderer* renderer, const char* layer, void (*setUp)(vtkRelievoLayersStage*, int), int setting)
{
  vtkRelievoPass* pass = vtkRelievoPass::Attach(renderer);
  setUp(pass->GetLayersStage(), setting);
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  source->AddLayer(layer);
  source->Update();
  vtkSmartPointer<vtkDataArray> drawn = source->GetOutput()->GetPointData()->GetArray(layer);
  vtkRelievoPass::Detach(renderer);
  return drawn;
}

// Errors in pixels.
struct Result
{
  Statistics Drawn;
  Statistics Alone; // error of the format alone
  std::size_t Pixels = 0;
  std::size_t OnEdges = 0;
};

Result Measure(
  const View& view, const TruthImage& truth, const Method& method, vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkDataArray> drawn = method.IsOffered()
    ? Draw(renderer, "position", method.SetUp, method.Setting)
    : Draw(renderer, "depth", DepthAlone, 0);
  Result result;
  std::vector<float> errors;
  std::vector<float> alone;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      if (!pixel.Hit || !pixel.Inner)
      {
        continue;
      }
      if (pixel.EdgeDistance < Grid)
      {
        ++result.OnEdges;
        continue;
      }
      const vtkIdType i = static_cast<vtkIdType>(y) * truth.Width + x;
      const relievoTest::Ray ray = view.PixelRay(x + 0.5, y + 0.5);
      glm::dvec3 position;
      if (method.IsOffered())
      {
        drawn->GetTuple(i, &position[0]);
      }
      else
      {
        position = method.Stored.Through(view, ray, drawn->GetComponent(i, 0));
      }
      // In units of a pixel's extent at that depth, across the view.
      const double span =
        glm::length(view.PixelRay(x + 1.5, y + 0.5).At(pixel.Depth) - ray.At(pixel.Depth));
      const auto inPixels = [&](const glm::dvec3& p) {
        return static_cast<float>(glm::length(p - pixel.Position) / span);
      };
      errors.push_back(inPixels(position));
      alone.push_back(inPixels(method.Stored.Through(view, ray, pixel.Depth)));
    }
  }
  result.Pixels = errors.size();
  result.Drawn = Summarize(errors);
  result.Alone = Summarize(alone);
  return result;
}

// Frame times of the methods, relative to a plain frame.
std::vector<relievoTest::TimingPair> TimeFrames(vtkPolyData* mesh, int rounds)
{
  const SceneWindow plain(mesh, Width, Height);
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<Timed> frames(1, plain.Frame());
  for (const Method& method : Methods)
  {
    windows.emplace_back(new SceneWindow(mesh, Width, Height));
    vtkRelievoPass* pass = vtkRelievoPass::Attach(windows.back()->Scene.Renderer);
    method.SetUp(pass->GetLayersStage(), method.Setting);
    pass->RequestLayer(method.Layer);
    frames.push_back(windows.back()->Frame());
  }
  const std::vector<Timing> times = TimeInTurn(frames, rounds);
  std::vector<relievoTest::TimingPair> pairs;
  for (std::size_t m = 0; m < std::size(Methods); ++m)
  {
    pairs.push_back(PairOf(times[m + 1], times[0]));
  }
  return pairs;
}

}

//------------------------------------------------------------------------------
int relievoBench::BenchPosition(const std::string& outDir, const PositionSizes& sizes)
{
  const vtkSmartPointer<vtkPolyData> mesh = SceneMesh("bunny");
  if (!mesh || !MakeFolder(outDir))
  {
    return 1;
  }
  const SceneWindow window(mesh, Width, Height);
  std::vector<std::vector<Result>> results;
  for (const Case& c : Cases)
  {
    Move(window.Scene, c);
    const View view(window.Scene.Renderer);
    const TruthImage truth = window.Scene.MakeTruth()->Trace(view);
    results.emplace_back();
    for (const Method& method : Methods)
    {
      const Result result = Measure(view, truth, method, window.Scene.Renderer);
      results.back().push_back(result);
      std::cout << c.Projection << " at " << c.Place << ", " << method.Name << ": median "
                << Number(result.Drawn.Median, 3) << ", p99 " << Number(result.Drawn.P99, 3)
                << ", max " << Number(result.Drawn.Max, 3) << ", format alone "
                << Number(result.Alone.Max, 3) << " pixels; " << result.Pixels << " pixels, "
                << result.OnEdges << " on edges left out" << std::endl;
    }
  }
  const std::vector<relievoTest::TimingPair> frames = TimeFrames(mesh, sizes.Rounds);
  Table table({ "format", "bytes", "from", "projection", "scene at", "pixels", "left out on edges",
    "error px median", "p99", "max", "max of the format alone", "times a plain frame", "+-",
    "frame measured with", "load" });
  for (std::size_t m = 0; m < std::size(Methods); ++m)
  {
    const Method& method = Methods[m];
    std::cout << method.Name << ": " << frames[m].ToString("frame", "plain frame") << std::endl;
    for (std::size_t c = 0; c < std::size(Cases); ++c)
    {
      const Result& result = results[c][m];
      table.AddRow({ method.Name, std::to_string(method.Bytes),
        method.IsOffered() ? "drawn" : "computed", Cases[c].Projection, Cases[c].Place,
        std::to_string(result.Pixels), std::to_string(result.OnEdges), Number(result.Drawn.Median),
        Number(result.Drawn.P99), Number(result.Drawn.Max), Number(result.Alone.Max),
        Number(frames[m].Ratio(), 3), Number(frames[m].RatioSpread(), 1),
        method.IsOffered() ? "itself" : method.StandIn, Number(LoadAverage(), 2) });
    }
  }
  return table.WriteCsv(outDir + "/position.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchPosition(const std::string& outDir)
{
  return BenchPosition(outDir, PositionSizes());
}
