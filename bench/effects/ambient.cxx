// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ambient occlusion: error of the sky's share against the time of a frame, by the number of rays;
// beside VTK's own, in screen space. Truth is Embree on the same triangles, with the same radius
// and many rays.
#include "BenchSizes.h"
#include "EmbreeScene.h"
#include "FrameBench.h"
#include "RelievoBench.h"
#include "Table.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoAmbientStage.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>
#include <vtkSSAOPass.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;

// White under ambient light only: a picture shows the share itself.
void Add(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  renderer->AddActor(actor);
}

void Add(vtkRenderer* renderer, vtkAlgorithm* source)
{
  source->Update();
  Add(renderer, vtkPolyData::SafeDownCast(source->GetOutputDataObject(0)));
}

void AddPlate(
  vtkRenderer* renderer, const double corner[3], const double first[3], const double second[3])
{
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(corner[0], corner[1], corner[2]);
  plate->SetPoint1(first[0], first[1], first[2]);
  plate->SetPoint2(second[0], second[1], second[2]);
  Add(renderer, plate);
}

void AddBox(vtkRenderer* renderer, double x, double y, double z, double sx, double sy, double sz)
{
  vtkNew<vtkCubeSource> box;
  box->SetCenter(x, y, z);
  box->SetXLength(sx);
  box->SetYLength(sy);
  box->SetZLength(sz);
  Add(renderer, box);
}

// A room of 4 x 2.5 x 4, open to the viewer, with a table, a cupboard and a ball. Returns the
// radius.
double MakeRoom(vtkRenderer* renderer)
{
  const double a[3] = { -2.0, 0.0, -2.0 };
  const double b[3] = { 2.0, 0.0, -2.0 };
  const double c[3] = { -2.0, 0.0, 2.0 };
  const double d[3] = { -2.0, 2.5, -2.0 };
  const double e[3] = { 2.0, 2.5, -2.0 };
  const double f[3] = { 2.0, 0.0, 2.0 };
  const double g[3] = { -2.0, 2.5, 2.0 };
  AddPlate(renderer, a, c, b); // floor
  AddPlate(renderer, a, b, d); // back
  AddPlate(renderer, a, d, c); // left
  AddPlate(renderer, b, f, e); // right
  AddPlate(renderer, d, e, g); // ceiling
  AddBox(renderer, 0.5, 0.72, -0.6, 1.4, 0.06, 0.8);
  for (const double x : { -0.15, 1.15 })
  {
    for (const double z : { -0.95, -0.25 })
    {
      AddBox(renderer, x, 0.345, z, 0.06, 0.69, 0.06);
    }
  }
  AddBox(renderer, -1.45, 0.9, -1.65, 0.9, 1.8, 0.6);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(-0.6, 0.35, 0.3);
  ball->SetRadius(0.35);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  Add(renderer, ball);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, 1.5, 6.0);
  camera->SetFocalPoint(0.0, 1.15, 0.0);
  camera->SetViewAngle(34.0);
  return 0.3;
}

// Returns 0 if the file is missing.
double MakeBunny(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkPolyData> mesh = SceneMesh("bunny");
  if (!mesh)
  {
    return 0.0;
  }
  Add(renderer, mesh);
  double bounds[6];
  mesh->GetBounds(bounds);
  const double size = mesh->GetLength();
  const double x = 0.5 * (bounds[0] + bounds[1]);
  const double z = 0.5 * (bounds[4] + bounds[5]);
  const double corner[3] = { x - 2.0 * size, bounds[2], z - 2.0 * size };
  const double first[3] = { x - 2.0 * size, bounds[2], z + 2.0 * size };
  const double second[3] = { x + 2.0 * size, bounds[2], z - 2.0 * size };
  AddPlate(renderer, corner, first, second);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(x, 0.5 * (bounds[2] + bounds[3]), z);
  camera->SetPosition(x + 0.4 * size, bounds[3] + 0.4 * size, z + 1.6 * size);
  return 0.15 * size;
}

using Shares = std::vector<double>; // by pixels, NaN in the background

// Weighted by the cosine, and by solid angle.
struct Truth
{
  Shares Cosine;
  Shares Uniform;
};

Truth FindTruth(vtkRenderer* renderer, double radius, int side)
{
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  for (const char* layer : { "position", "geometric_normal", "depth" })
  {
    source->AddLayer(layer);
  }
  source->Update();
  vtkPointData* layers = source->GetOutput()->GetPointData();
  relievoTest::EmbreeScene scene;
  scene.AddActors(renderer);
  const double start = 1e-5 * scene.Size();
  const vtkIdType count = source->GetOutput()->GetNumberOfPoints();
  Truth truth;
  truth.Cosine.assign(static_cast<std::size_t>(count), std::numeric_limits<double>::quiet_NaN());
  truth.Uniform = truth.Cosine;
  const auto find = [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      double p[3];
      double n[3];
      if (!std::isfinite(layers->GetArray("depth")->GetComponent(i, 0)))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        p[k] = layers->GetArray("position")->GetComponent(i, k);
        n[k] = layers->GetArray("geometric_normal")->GetComponent(i, k);
      }
      const glm::dvec3 up = glm::normalize(glm::dvec3(n[0], n[1], n[2]));
      const glm::dvec3 place = glm::dvec3(p[0], p[1], p[2]) + start * up;
      std::mt19937 lots(static_cast<unsigned>(i));
      std::uniform_real_distribution<double> share(0.0, 1.0);
      double open[2] = { 0.0, 0.0 };
      double all[2] = { 0.0, 0.0 };
      for (int k = 0; k < side * side; ++k)
      {
        // Stratified on the hemisphere, with or without cosine weighting.
        const double z = 2.0 * (k % side + share(lots)) / side - 1.0;
        const double angle = 2.0 * vtkMath::Pi() * (k / side + share(lots)) / side;
        const double r = std::sqrt(1.0 - z * z);
        glm::dvec3 ray(r * std::cos(angle), r * std::sin(angle), z);
        const double cosine = glm::dot(ray, up);
        ray = cosine < 0.0 ? ray - 2.0 * cosine * up : ray;
        const bool hit = scene.Cast({ place, ray }, 0.0, radius).Hit;
        const double weights[2] = { std::abs(cosine), 1.0 };
        for (int w = 0; w < 2; ++w)
        {
          open[w] += hit ? 0.0 : weights[w];
          all[w] += weights[w];
        }
      }
      truth.Cosine[static_cast<std::size_t>(i)] = open[0] / all[0];
      truth.Uniform[static_cast<std::size_t>(i)] = open[1] / all[1];
    }
  };
  vtkSMPTools::For(0, count, 256, find);
  return truth;
}

double GetRms(const Shares& truth, const std::function<double(std::size_t)>& found)
{
  double sum = 0.0;
  double pixels = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    if (std::isfinite(truth[i]))
    {
      sum += (found(i) - truth[i]) * (found(i) - truth[i]);
      pixels += 1.0;
    }
  }
  return std::sqrt(sum / pixels);
}

// The best time of some frames, each redrawn.
double Time(int rounds, const std::function<void()>& frame)
{
  frame(); // shaders, trees
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < rounds; ++i)
  {
    const auto from = std::chrono::steady_clock::now();
    frame();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - from;
    best = std::min(best, took.count());
  }
  return best;
}

class Bench
{
public:
  Bench(const std::string& name, vtkRenderer* renderer, double radius, const AmbientSizes& sizes,
    Table& table)
    : Name(name)
    , Renderer(renderer)
    , Radius(radius)
    , Sizes(sizes)
    , Rows(table)
    , Window(relievoTest::MakeWindow(sizes.Width, sizes.Height, renderer))
    , True(FindTruth(renderer, radius, sizes.TruthSide))
  {
    this->Plain = Time(sizes.Rounds, [this] { relievoTest::Picture(this->Window); });
  }

  void MeasureRays()
  {
    vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Renderer);
    auto* stage = vtkRelievoAmbientStage::SafeDownCast(frame->GetStage("ambient"));
    stage->SetRadius(this->Radius);
    stage->SetAtOnce(true);
    for (const int samples : this->Sizes.Samples)
    {
      stage->SetSamples(samples);
      stage->SetSamplesPerFrame(std::min(samples, 64));
      stage->SetEnabled(true);
      double strength = 1.0;
      const double time = Time(this->Sizes.Rounds, [&] {
        strength = strength == 1.0 ? 0.99 : 1.0; // traces all rays again
        stage->SetStrength(strength);
        relievoTest::Picture(this->Window);
      });
      stage->SetEnabled(false);
      vtkNew<vtkRelievoLayerSource> source;
      source->SetRenderer(this->Renderer);
      source->AddLayer("ambient");
      source->Update();
      auto* shares =
        vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("ambient"));
      this->AddRow("rays", samples,
        GetRms(this->True.Cosine,
          [shares](std::size_t i) { return shares->GetValue(static_cast<vtkIdType>(i)); }),
        time);
    }
    vtkRelievoPass::Detach(this->Renderer);
  }

  // Compares with the nearer of both truths.
  void MeasurePeer()
  {
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> pass;
    pass->SetDelegatePass(steps);
    pass->SetRadius(this->Radius);
    pass->SetBias(0.01 * this->Radius);
    pass->BlurOn();
    this->Renderer->SetPass(pass);
    for (const int samples : this->Sizes.Samples)
    {
      pass->SetKernelSize(static_cast<unsigned>(samples));
      vtkSmartPointer<vtkImageData> picture;
      const double time =
        Time(this->Sizes.Rounds, [&] { picture = relievoTest::Picture(this->Window); });
      const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
      const auto found = [bytes](std::size_t i) { return bytes[3 * i] / 255.0; };
      this->AddRow("vtkSSAOPass", samples,
        std::min(GetRms(this->True.Cosine, found), GetRms(this->True.Uniform, found)), time);
    }
    this->Renderer->SetPass(nullptr);
    pass->ReleaseGraphicsResources(this->Window);
  }

private:
  void AddRow(const std::string& method, int samples, double rms, double time)
  {
    this->Rows.AddRow({ this->Name, method, std::to_string(samples), Number(this->Radius),
      Number(rms), Number(time), Number(this->Plain), Number(LoadAverage()) });
    std::cout << this->Name << ", " << method << ", " << samples << " samples: rms " << Number(rms)
              << ", " << Number(time) << " ms (plain " << Number(this->Plain) << ")" << std::endl;
  }

  std::string Name;
  vtkRenderer* Renderer;
  double Radius;
  const AmbientSizes& Sizes;
  Table& Rows;
  vtkSmartPointer<vtkRenderWindow> Window;
  Truth True;
  double Plain = 0.0;
};
}

//------------------------------------------------------------------------------
int relievoBench::BenchAmbient(const std::string& outDir, const AmbientSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "method", "samples", "radius", "rms", "milliseconds", "plain milliseconds",
    "load" });
  for (const std::string& name : sizes.Scenes)
  {
    vtkNew<vtkRenderer> renderer;
    const double radius = name == "bunny" ? MakeBunny(renderer) : MakeRoom(renderer);
    if (!(radius > 0.0))
    {
      return 1;
    }
    renderer->ResetCameraClippingRange();
    Bench bench(name, renderer, radius, sizes, table);
    bench.MeasureRays();
    bench.MeasurePeer();
  }
  return table.WriteCsv(outDir + "/ambient.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchAmbient(const std::string& outDir)
{
  return relievoBench::BenchAmbient(outDir, {});
}
