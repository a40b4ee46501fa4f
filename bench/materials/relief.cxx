// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 7: misses of relief methods, and their errors of depth and normal, against the reads of the
// heights and the time of a frame; and a plane with relief against the geometry that it represents.
//
// Truth is a ray marched in double precision through the height field itself, and Embree on the
// full geometry. Reads are counted by the same steps on the CPU.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "EmbreeScene.h"
#include "FrameBench.h"
#include "ReliefTruth.h"
#include "Table.h"
#include "View.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoMaterial.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using namespace relievoTest;

constexpr double Scale = 0.2; // a tenth of the tile
ReliefSizes Sizes;            // of the run
using Material = vtkRelievoMaterial;

struct Way
{
  const char* Name;
  int Method;
  int Steps; // 0: by the number of texels passed over
};
const Way Ways[] = {
  { "parallax", Material::METHOD_PARALLAX, 1 },
  { "steep 16", Material::METHOD_STEEP, 16 },
  { "steep 32", Material::METHOD_STEEP, 32 },
  { "steep 64", Material::METHOD_STEEP, 64 },
  { "occlusion 16", Material::METHOD_OCCLUSION, 16 },
  { "occlusion 32", Material::METHOD_OCCLUSION, 32 },
  { "occlusion 64", Material::METHOD_OCCLUSION, 64 },
  { "relief 16", Material::METHOD_RELIEF, 16 },
  { "relief 32", Material::METHOD_RELIEF, 32 },
  { "relief 64", Material::METHOD_RELIEF, 64 },
  { "occlusion, by texels", Material::METHOD_OCCLUSION, 0 },
  { "relief, by texels (default)", Material::METHOD_RELIEF, 0 },
};

struct ReliefWindow
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<Material> Surface;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit ReliefWindow(vtkPolyData* mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window = MakeWindow(Sizes.Width, Sizes.Height, this->Renderer);
    LookAtRelief(this->Renderer, 60.);
  }
  ~ReliefWindow() { this->Surface->Detach(this->Actor); }

  void SetStyle(const HeightField& field, int texels, const Way& way)
  {
    this->Surface->SetHeightMap(HeightImage(field, texels));
    this->Surface->SetHeightRange(0., 1.);
    this->Surface->SetHeightScale(Scale);
    this->Surface->DepthCorrectionOn();
    this->Surface->SetReliefMethod(way.Method);
    if (way.Steps > 0)
    {
      this->Surface->SetMinimumSteps(way.Steps);
      this->Surface->SetMaximumSteps(way.Steps);
    }
    this->Surface->Attach(this->Actor);
  }

  vtkSmartPointer<vtkImageData> Capture()
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(this->Renderer);
    source->AddLayer("depth");
    source->AddLayer("normal");
    source->Update();
    return source->GetOutput();
  }

  Timed Frame() const { return relievoTest::Frame(this->Window); }
};

// Reads of the heights for one ray, by the steps of shaders/material/surface.glsl.
double CountLooks(Material* surface, const HeightField& field, const ReliefRay& ray)
{
  if (surface->GetReliefMethod() == Material::METHOD_PARALLAX)
  {
    return 1.;
  }
  const glm::dvec2 through = ReliefTCoord(ray, Scale, 1.) - ReliefTCoord(ray, Scale, 0.);
  const double steps =
    std::clamp(std::ceil(glm::length(through) * Sizes.Texels * surface->GetStepsPerTexel()),
      static_cast<double>(surface->GetMinimumSteps()),
      static_cast<double>(surface->GetMaximumSteps()));
  double looks = 1.;
  for (double i = 1.; i <= steps; i += 1.)
  {
    looks += 1.;
    if (1. - i / steps <= field(ReliefTCoord(ray, Scale, i / steps)))
    {
      break;
    }
  }
  return looks +
    (surface->GetReliefMethod() == Material::METHOD_RELIEF ? surface->GetBisections() : 0);
}

double MeanLooks(ReliefWindow& window, const HeightField& field)
{
  double looks = 0.;
  int rays = 0;
  for (int y = 4; y < Sizes.Height; y += 9)
  {
    for (int x = 4; x < Sizes.Width; x += 9)
    {
      const ReliefRay ray = RayOf(window.Renderer, x, y);
      if (ray.HitsPlane)
      {
        looks += CountLooks(window.Surface, field, ray);
        ++rays;
      }
    }
  }
  return looks / rays;
}

struct Field
{
  const char* Name;
  HeightField Truth;
};

// The field as a mesh of 2 x cells x cells triangles, with the plane's texture coordinates.
vtkSmartPointer<vtkPolyData> FullGeometry(const HeightField& field, int corners)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int j = 0; j < corners; ++j)
  {
    for (int i = 0; i < corners; ++i)
    {
      const glm::dvec2 uv = glm::dvec2(i, j) / (corners - 1.);
      points->InsertNextPoint(2. * uv.x - 1., 2. * uv.y - 1., (field(uv) - 1.) * Scale);
      const glm::dvec3 n = glm::normalize(glm::dvec3(-SlopeOf(field, uv) * Scale / 2., 1.));
      normals->InsertNextTuple3(n.x, n.y, n.z);
    }
  }
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j + 1 < corners; ++j)
  {
    for (int i = 0; i + 1 < corners; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * corners + i;
      const vtkIdType c = a + corners;
      triangles->InsertNextCell({ a, a + 1, c + 1 });
      triangles->InsertNextCell({ a, c + 1, c });
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

std::vector<unsigned char> Pixels(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Sizes.Width - 1, Sizes.Height - 1, 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

// A plane of two triangles with relief against two million triangles.
bool BenchGeometry(const std::string& outDir)
{
  ReliefWindow plain(ReliefPlane(1));
  ReliefWindow mapped(ReliefPlane(1));
  mapped.SetStyle(Waves, Sizes.FullCells, { "normals", Material::METHOD_OFF, 0 });
  ReliefWindow normals(ReliefPlane(1));
  normals.Surface->SetNormalMap(NormalImage(Waves, Sizes.FullCells));
  normals.Surface->Attach(normals.Actor);
  ReliefWindow off(ReliefPlane(1));
  off.SetStyle(Waves, Sizes.FullCells, Ways[std::size(Ways) - 1]);
  off.Surface->EnabledOff();
  ReliefWindow relief(ReliefPlane(1));
  relief.SetStyle(Waves, Sizes.FullCells, Ways[std::size(Ways) - 1]);
  relief.Surface->ClipAtBordersOn();
  const vtkSmartPointer<vtkPolyData> mesh = FullGeometry(Waves, Sizes.FullCells + 1);
  ReliefWindow full(mesh);
  const auto times = TimeInTurn(
    { plain.Frame(), normals.Frame(), mapped.Frame(), off.Frame(), relief.Frame(), full.Frame() },
    Sizes.Rounds);

  // Compares depth with Embree on the full geometry, and the pictures.
  const vtkSmartPointer<vtkImageData> layers = relief.Capture();
  EmbreeScene embree;
  embree.AddActor(mesh);
  const TruthImage truth = embree.Trace(View(relief.Renderer));
  vtkDataArray* depths = layers->GetPointData()->GetArray("depth");
  double off5 = 0.;
  double mean = 0.;
  double difference = 0.;
  int count = 0;
  const auto a = Pixels(relief.Window);
  const auto b = Pixels(full.Window);
  for (int y = 0; y < Sizes.Height; ++y)
  {
    for (int x = 0; x < Sizes.Width; ++x)
    {
      const double seen = depths->GetComponent(static_cast<vtkIdType>(y) * Sizes.Width + x, 0);
      const PixelTruth& pixel = truth.At(x, y);
      if (pixel.Hit && std::isfinite(seen))
      {
        const double error = std::abs(seen - pixel.Depth) / Scale;
        off5 += error > 0.05 ? 1. : 0.;
        mean += error > 0.05 ? 0. : error;
        ++count;
        for (int c = 0; c < 3; ++c)
        {
          const std::size_t i = (static_cast<std::size_t>(y) * Sizes.Width + x) * 3 + c;
          difference += std::abs(static_cast<double>(a[i]) - b[i]) / 3.;
        }
      }
    }
  }

  Table table({ "drawn", "ms", "times the plane", "+-", "times the full geometry", "+-" });
  const std::string triangles = std::to_string(2 * Sizes.FullCells * Sizes.FullCells);
  const std::string names[] = { "plane of 2 triangles", "plane with a normal map",
    "plane with normals of heights", "plane with its material off", "plane with relief",
    "full geometry, " + triangles + " triangles" };
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const TimingPair plane = PairOf(times[i], times[0]);
    const TimingPair whole = PairOf(times[i], times.back());
    std::cout << names[i] << ": " << plane.ToString("frame", "plane") << "; "
              << Number(whole.Ratio(), 3) << " of the full geometry" << std::endl;
    table.AddRow({ names[i], Number(1000. * times[i].Median(), 4), Number(plane.Ratio(), 3),
      Number(plane.RatioSpread(), 1), Number(whole.Ratio(), 3), Number(whole.RatioSpread(), 1) });
  }
  std::cout
    << "relief against the full geometry (Embree): depth off by more than 5 % of the height "
    << Number(100. * off5 / count, 3) << " % of pixels, mean of the others "
    << Number(100. * mean / count, 3) << " %; pictures differ by " << Number(difference / count, 3)
    << " grey levels in the mean, where both draw" << std::endl;
  return table.WriteCsv(outDir + "/relief-geometry.csv");
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchRelief(const std::string& outDir, const ReliefSizes& sizes)
{
  Sizes = sizes;
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  const Field fields[] = { { "waves", Waves },
    { "posts 4 texels thin", Sampled(Posts(4. / Sizes.Texels), Sizes.Texels) } };
  ReliefWindow plain(ReliefPlane(4));
  std::vector<std::unique_ptr<ReliefWindow>> windows;
  std::vector<Timed> frames(1, plain.Frame());
  for (const Way& way : Ways)
  {
    windows.emplace_back(new ReliefWindow(ReliefPlane(4)));
    windows.back()->SetStyle(Waves, Sizes.Texels, way);
    frames.push_back(windows.back()->Frame());
  }
  const auto times = TimeInTurn(frames, Sizes.Rounds);

  Table table({ "field", "method", "degrees", "looks", "missed %", "depth error % of height",
    "normal error degrees", "times a plain frame (waves, 60)", "+-" });
  for (const Field& field : fields)
  {
    const bool waves = &field == fields;
    for (std::size_t w = 0; w < std::size(Ways); ++w)
    {
      const Way& way = Ways[w];
      ReliefWindow& window = *windows[w];
      window.SetStyle(field.Truth, Sizes.Texels, way);
      const TimingPair time = PairOf(times[w + 1], times[0]);
      for (const double angle : Sizes.Angles)
      {
        LookAtRelief(window.Renderer, angle);
        if (!waves)
        {
          window.Renderer->GetActiveCamera()->SetViewAngle(8.); // makes a texel at least a pixel
        }
        const ReliefErrors e =
          CompareRelief(window.Capture(), window.Renderer, field.Truth, Scale, 9);
        const double looks = MeanLooks(window, field.Truth);
        std::cout << field.Name << ", " << way.Name << " at " << angle << ": " << Number(looks, 3)
                  << " looks, missed " << Number(100. * e.Missed, 3) << " %, depth "
                  << Number(100. * e.Depth, 3) << " %, normal " << Number(e.Normal, 3) << " degrees"
                  << std::endl;
        table.AddRow({ field.Name, way.Name, Number(angle, 3), Number(looks, 3),
          Number(100. * e.Missed, 3), Number(100. * e.Depth, 3), Number(e.Normal, 3),
          Number(time.Ratio(), 3), Number(time.RatioSpread(), 1) });
      }
    }
  }
  windows.clear();
  const bool written = BenchGeometry(outDir) && table.WriteCsv(outDir + "/relief.csv");
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchRelief(const std::string& outDir)
{
  return BenchRelief(outDir, ReliefSizes());
}
