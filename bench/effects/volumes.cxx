// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes: error and cost of ways to find the light that they let pass, against closed forms (of
// "waves", which has none, against rays in double, whose row is 0): the grid along a light's rays
// by its nodes, a march from every place by its step, one in double, and Fourier terms for each ray
// (J. Jansen, L. Bavoil: Fourier opacity mapping, 2010). Then frames of a volume above a ground:
// time and memory by its size, beside VTK's plain volume and its volumetric scattering, and the
// error of the shadow on the ground.
#include "VolumeSizes.h"

#include "FrameBench.h"
#include "Table.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoOpticalDepths.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPlacedVolume.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoVolumeExtinction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <glm/glm.hpp>

#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using Source = vtkRelievoOpticalDepths::Source;
using Fields = std::vector<vtkRelievoVolumeExtinction>;

constexpr double Pi = 3.14159265358979323846;
constexpr int Pixels = 600; // each side of a frame
constexpr double Steepest = 3.0;
const glm::dvec3 Corner(-0.6, 0.7, -0.6);
constexpr double Side = 1.2;
const glm::dvec3 Towards(1.0, 3.0, 1.5); // the sun

// The extinction at a place from 0 to 1 in the box, as a share of the steepest, and the integral
// from the light to a place; null: none in closed form.
struct Scene
{
  const char* Name;
  std::function<double(const glm::dvec3&)> Extinction;
  std::function<double(const glm::dvec3& place, const glm::dvec3& direction)> Depth;
};

// Where a ray up to a place is within the box, by its distance before the place.
glm::dvec2 FindChord(const glm::dvec3& place, const glm::dvec3& direction)
{
  double first = -std::numeric_limits<double>::infinity();
  double last = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double a = (Corner[i] - place[i]) / direction[i];
    const double b = (Corner[i] + Side - place[i]) / direction[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return last > first ? glm::dvec2(first, last) : glm::dvec2(0.0);
}

// A ball whose extinction falls as 1 - r^2 from its centre.
double GetBallDepth(const glm::dvec3& place, const glm::dvec3& direction)
{
  const double radius = 0.5 * Side;
  const glm::dvec3 off = place - (Corner + radius);
  const double along = glm::dot(off, direction);
  const double rest = radius * radius - glm::dot(off, off);
  const double half2 = along * along + rest;
  if (half2 <= 0.0)
  {
    return 0.0;
  }
  const auto integral = [&](double t) {
    return Steepest / (radius * radius) * (rest * t - along * t * t - t * t * t / 3.0);
  };
  const double first = -along - std::sqrt(half2);
  const double last = std::min(0.0, -along + std::sqrt(half2));
  return last > first ? integral(last) - integral(first) : 0.0;
}

const Scene Scenes[] = {
  { "box", [](const glm::dvec3&) { return 0.4; },
    [](const glm::dvec3& place, const glm::dvec3& direction) {
      const glm::dvec2 chord = FindChord(place, direction);
      return 0.4 * Steepest * (chord.y - chord.x);
    } },
  { "ramp", [](const glm::dvec3& place) { return place.x; },
    [](const glm::dvec3& place, const glm::dvec3& direction) {
      const glm::dvec2 chord = FindChord(place, direction);
      const double middle = place.x + 0.5 * (chord.x + chord.y) * direction.x - Corner.x;
      return Steepest * middle / Side * (chord.y - chord.x);
    } },
  { "ball",
    [](const glm::dvec3& place) {
      const glm::dvec3 off = 2.0 * place - 1.0;
      return std::max(0.0, 1.0 - glm::dot(off, off));
    },
    GetBallDepth },
  { "waves",
    [](const glm::dvec3& place) {
      const glm::dvec3 wave = glm::sin(4.0 * Pi * place);
      return std::max(0.0, wave.x * wave.y * wave.z);
    },
    nullptr },
};

struct Volume
{
  Volume(const Scene& scene, int size)
  {
    const double spacing = Side / (size - 1);
    this->Image->SetDimensions(size, size, size);
    this->Image->SetSpacing(spacing, spacing, spacing);
    this->Image->SetOrigin(Corner.x, Corner.y, Corner.z);
    this->Image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
    auto* to = static_cast<unsigned short*>(this->Image->GetScalarPointer());
    for (int k = 0; k < size; ++k)
    {
      for (int j = 0; j < size; ++j)
      {
        for (int i = 0; i < size; ++i)
        {
          const double share = scene.Extinction(glm::dvec3(i, j, k) / (size - 1.0));
          *to++ = static_cast<unsigned short>(std::lround(65535.0 * share));
        }
      }
    }
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i <= 512; ++i)
    {
      const double share = i / 512.0;
      opacity->AddPoint(65535.0 * share, 1.0 - std::exp(-Steepest * share));
    }
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 1.0, 0.9, 0.8);
    vtkVolumeProperty* property = this->Prop->GetProperty();
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    property->SetInterpolationTypeToLinear();
    property->ShadeOn();
    this->Mapper->SetInputData(this->Image);
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(static_cast<float>(spacing));
    this->Mapper->UseJitteringOff();
    this->Prop->SetMapper(this->Mapper);
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Prop;
};

double GetProcessorMilliseconds()
{
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Places in the box and, one in three, behind it, and the truth at each.
struct Places
{
  std::vector<glm::dvec3> At;
  std::vector<double> Depths;

  Places(const Scene& scene, const Fields& fields, const Source& source, int count)
  {
    for (int i = 1; i <= count; ++i)
    {
      const glm::dvec3 share = glm::fract(
        0.5 + static_cast<double>(i) * glm::dvec3(0.8191725134, 0.6710436067, 0.5497004779));
      const glm::dvec3 place =
        Corner + Side * share + (i % 3 == 0 ? 1.5 * Side : 0.0) * source.Direction;
      this->At.push_back(place);
      this->Depths.push_back(scene.Depth
          ? scene.Depth(place, source.Direction)
          : vtkRelievoOpticalDepths::GetExactDepth(fields, source, place));
    }
  }
};

void AddRow(Table& table, const Scene& scene, int size, const std::string& method,
  const std::string& setting, const Places& places,
  const std::function<double(const glm::dvec3&)>& getDepth, double milliseconds, double bytes)
{
  double squares = 0.0;
  double worst = 0.0;
  double depthSquares = 0.0;
  const double before = GetProcessorMilliseconds();
  for (std::size_t i = 0; i < places.At.size(); ++i)
  {
    const double depth = getDepth(places.At[i]);
    const double error = std::abs(std::exp(-depth) - std::exp(-places.Depths[i]));
    squares += error * error;
    worst = std::max(worst, error);
    depthSquares += (depth - places.Depths[i]) * (depth - places.Depths[i]);
  }
  const auto count = static_cast<double>(places.At.size());
  // Without a grid, each pixel of a frame costs.
  const double cost = milliseconds > 0.0
    ? milliseconds
    : (GetProcessorMilliseconds() - before) / count * Pixels * Pixels;
  table.AddRow({ scene.Name, std::to_string(size), method, setting,
    Number(std::sqrt(squares / count)), Number(worst), Number(std::sqrt(depthSquares / count)),
    Number(cost), Number(bytes / 1048576.0) });
  std::cout << scene.Name << " " << size << ", " << method << " " << setting << ": rms "
            << Number(std::sqrt(squares / count), 2) << ", worst " << Number(worst, 2) << ", "
            << Number(cost, 3) << " ms, " << Number(bytes / 1048576.0, 3) << " MiB" << std::endl;
}

void MeasureTransmittance(const Scene& scene, int size, const VolumeSizes& sizes, Table& table)
{
  const Volume volume(scene, size);
  std::string why;
  const Fields fields = vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why);
  Source source;
  source.Direction = -glm::normalize(Towards);
  const bool large = size > sizes.Largest; // only the default there
  const Places places(scene, fields, source, sizes.Places);
  for (const int nodes : sizes.Nodes)
  {
    if (nodes > 2 * size || (large && nodes != 256))
    {
      continue;
    }
    // By nodes along rays, and for one number of them by 7 to 31 terms of each ray.
    for (const int harmonics :
      nodes == sizes.FourierNodes ? std::vector<int>{ 0, 3, 7, 15 } : std::vector<int>{ 0 })
    {
      vtkRelievoOpticalDepths grid;
      const double before = GetProcessorMilliseconds();
      grid.Make(fields, source, nodes, harmonics);
      const double making = GetProcessorMilliseconds() - before;
      AddRow(
        table, scene, size, harmonics > 0 ? "Fourier terms" : "grid",
        std::to_string(harmonics > 0 ? grid.GetStored().z : nodes), places,
        [&](const glm::dvec3& place) { return grid.GetDepth(place); }, making,
        2.0 * static_cast<double>(grid.GetDepths().size()));
    }
  }
  if (large)
  {
    return;
  }
  for (const double step : { 4.0, 2.0, 1.0, 0.5 })
  {
    const double spacing = Side / (size - 1);
    AddRow(
      table, scene, size, "march", Number(step) + " voxels", places,
      [&](const glm::dvec3& place) {
        const double way = 3.0 * Side;
        std::vector<float> depths(static_cast<std::size_t>(std::ceil(way / (step * spacing))));
        std::vector<glm::vec3> none;
        const auto pieces = static_cast<double>(depths.size());
        fields[0].AddDepths(
          place - way * source.Direction, way / pieces * source.Direction, 1, depths, none);
        double sum = 0.0;
        for (const float depth : depths)
        {
          sum += depth;
        }
        return sum;
      },
      0.0, 0.0);
  }
  AddRow(
    table, scene, size, "exact", "1e-6", places,
    [&](const glm::dvec3& place) {
      return vtkRelievoOpticalDepths::GetExactDepth(fields, source, place);
    },
    0.0, 0.0);
}

// The volume above a ground.
struct Window
{
  explicit Window(const Scene& scene, int size)
    : Cloud(scene, size)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-3.0, 0.0, 3.0);
    plane->SetPoint1(3.0, 0.0, 3.0);
    plane->SetPoint2(-3.0, 0.0, -3.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> ground;
    ground->SetMapper(mapper);
    this->Renderer->AddActor(ground);
    this->Renderer->AddVolume(this->Cloud.Prop);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(Towards.x, Towards.y, Towards.z);
    this->Renderer->AddLight(this->Light);
    this->Renderer->SetBackground(0.2, 0.2, 0.2);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 5.0, 5.0);
    camera->SetFocalPoint(0.0, 0.5, 0.0);
    this->Renderer->ResetCameraClippingRange();
    this->Drawn->SetSize(Pixels, Pixels);
    this->Drawn->SetMultiSamples(0);
    this->Drawn->SetOffScreenRendering(1);
    this->Drawn->AddRenderer(this->Renderer);
  }

  vtkRelievoShadowStage* GetShadows() const
  {
    return vtkRelievoPass::Attach(this->Renderer)->GetShadowStage();
  }

  Volume Cloud;
  vtkNew<vtkLight> Light;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Drawn;
};

// The rms error in levels of 255 of the ground's light, over the pixels that the ball dims; of a
// ground without shadows, its whole shadow.
double GetLevels(const Window& window, bool shadowed)
{
  vtkNew<vtkRelievoLayerSource> layers;
  layers->SetRenderer(window.Renderer);
  layers->AddLayer("shadow_0");
  layers->AddLayer("position");
  layers->Update();
  vtkPointData* data = layers->GetOutput()->GetPointData();
  vtkDataArray* light = data->GetArray("shadow_0");
  vtkDataArray* position = data->GetArray("position");
  double squares = 0.0;
  long long count = 0;
  const glm::dvec3 direction = -glm::normalize(Towards);
  for (vtkIdType i = 0; light && position && i < light->GetNumberOfTuples(); ++i)
  {
    const glm::dvec3 place(
      position->GetComponent(i, 0), position->GetComponent(i, 1), position->GetComponent(i, 2));
    const double depth = std::isfinite(glm::length(place)) ? GetBallDepth(place, direction) : 0.0;
    if (depth > 0.0)
    {
      const double error = (shadowed ? light->GetTuple1(i) : 1.0) - std::exp(-depth);
      squares += error * error;
      ++count;
    }
  }
  return count > 0 ? 255.0 * std::sqrt(squares / static_cast<double>(count))
                   : std::numeric_limits<double>::quiet_NaN();
}

// VTK 9.2 has volumetric scattering: it marches towards the light from every sample.
template <typename Mapper>
auto Scatter(Mapper* mapper, int) -> decltype(mapper->SetVolumetricScatteringBlending(1.f), true)
{
  mapper->SetVolumetricScatteringBlending(1.f);
  mapper->SetGlobalIlluminationReach(1.f);
  return true;
}
template <typename Mapper>
bool Scatter(Mapper*, long)
{
  return false;
}

void MeasureFrames(int size, int rounds, Table& table)
{
  const Scene& ball = Scenes[2];
  struct Way
  {
    std::string Name;
    bool Shadows;
    bool Moves;
    bool Scatters;
    int Harmonics;
  };
  std::vector<Way> ways = { { "plain", false, false, false, 0 },
    { "shadows, still", true, false, false, 0 },
    { "shadows, the light moves", true, true, false, 0 },
    { "15 Fourier terms, still", true, false, false, 7 },
    { "15 Fourier terms, the light moves", true, true, false, 7 } };
  if (size <= 128 && Scatter(vtkNew<vtkGPUVolumeRayCastMapper>().Get(), 0))
  {
    ways.push_back({ "VTK's volumetric scattering", false, false, true, 0 });
  }
  std::vector<std::unique_ptr<Window>> windows;
  std::vector<relievoTest::Timed> frames;
  for (const Way& way : ways)
  {
    windows.emplace_back(new Window(ball, size));
    Window* window = windows.back().get();
    if (way.Shadows)
    {
      window->GetShadows()->EnabledOn();
      window->GetShadows()->SetVolumeHarmonics(way.Harmonics);
    }
    if (way.Scatters)
    {
      Scatter(window->Cloud.Mapper.Get(), 0);
    }
    auto count = std::make_shared<int>(0);
    frames.push_back(relievoTest::Frame(window->Drawn, [window, way, count]() {
      if (way.Moves)
      {
        window->Light->SetPosition(Towards.x + 0.02 * (++*count % 50), Towards.y, Towards.z);
      }
    }));
  }
  std::vector<relievoTest::Timing> times;
  TimeInTurn(frames, rounds, times);
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const auto pair = PairOf(times[i], times[0]);
    const double bytes =
      ways[i].Shadows ? static_cast<double>(windows[i]->GetShadows()->GetBytesHeld()) : 0.0;
    windows[i]->Light->SetPosition(Towards.x, Towards.y, Towards.z);
    const double levels = ways[i].Moves ? std::numeric_limits<double>::quiet_NaN()
                                        : GetLevels(*windows[i], ways[i].Shadows);
    table.AddRow({ std::to_string(size), ways[i].Name, Number(1e3 * times[i].Median()),
      Number(pair.Ratio()), Number(pair.RatioSpread(), 2), Number(bytes / 1048576.0),
      std::isnan(levels) ? std::string() : Number(levels) });
    std::cout << size << ", " << ways[i].Name << ": " << Number(1e3 * times[i].Median(), 3)
              << " ms, " << Number(pair.Ratio(), 3) << " +- " << Number(pair.RatioSpread(), 1)
              << " x plain, " << Number(bytes / 1048576.0, 3) << " MiB, rms " << Number(levels, 3)
              << " levels" << std::endl;
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchVolumes(const std::string& outDir, const VolumeSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table(
    { "scene", "size", "method", "setting", "rms", "worst", "depth rms", "milliseconds", "MiB" });
  for (const int size : sizes.Sizes)
  {
    for (const Scene& scene : Scenes)
    {
      if (size <= sizes.Largest || &scene == &Scenes[2])
      {
        MeasureTransmittance(scene, size, sizes, table);
      }
    }
  }
  Table frames({ "size", "frame", "processor ms", "times plain", "+-", "MiB", "levels rms" });
  for (const int size : sizes.FrameSizes)
  {
    MeasureFrames(size, size > 128 ? 3 : sizes.Rounds, frames);
  }
  return table.WriteCsv(outDir + "/volumes.csv") && frames.WriteCsv(outDir + "/volume-frames.csv")
    ? 0
    : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchVolumes(const std::string& outDir)
{
  return relievoBench::BenchVolumes(outDir, {});
}
