// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 8: error of an environment's light stored in texels, by the map, by the number of texels,
// and by the angle from the map's axis.
//
// Texels are means over their solid angles and are read bilinearly across all seams; the truth is
// the environment itself, in double, at directions evenly spread over the sphere.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "EnvironmentMaps.h"
#include "Table.h"
#include "vtkRelievoFormulas.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoEXRReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
constexpr double Pi = 3.14159265358979323846;
constexpr int Belts = 18; // of 10 degrees

struct Way
{
  EnvironmentMap Map;
  const char* Name;
  int Axis; // from which angles are counted: where the map is most accurate, or its pole
};

const Way Ways[] = {
  { EnvironmentMap::Cube, "cube", 2 },
  { EnvironmentMap::WarpedCube, "tan-warped cube", 2 },
  { EnvironmentMap::Octahedral, "octahedral", 2 },
  { EnvironmentMap::SphereMap, "sphere map", 2 },
  { EnvironmentMap::Latitudes, "lat-long", 1 },
};

// Evenly spread directions: a spiral of golden angles.
glm::dvec3 Look(int i, int looks)
{
  const double z = 1. - (2. * i + 1.) / looks;
  const double turn = Pi * (3. - std::sqrt(5.)) * i;
  const double r = std::sqrt(1. - z * z);
  return { r * std::cos(turn), r * std::sin(turn), z };
}

// Rotates about an axis by an angle, both from golden sections: rotations differ strongly.
glm::dvec3 Turned(int turn, int turns, const glm::dvec3& d)
{
  const double z = 1. - (2. * turn + 1.) / turns;
  const double side = std::sqrt(1. - z * z);
  const glm::dvec3 axis(side * std::cos(2.4 * turn), z, side * std::sin(2.4 * turn));
  const double angle = 1. + 2.4 * turn;
  return std::cos(angle) * d + std::sin(angle) * glm::cross(axis, d) +
    (1. - std::cos(angle)) * glm::dot(axis, d) * axis;
}

// A sky with a brighter horizon, a darker ground, and lobes 25 to 3 degrees wide around directions
// spread over the sphere.
glm::dvec3 SkyAndLobes(const glm::dvec3& d)
{
  const double up = 1. / (1. + std::exp(-12. * d.y));
  glm::dvec3 light = up * (glm::dvec3(0.3, 0.5, 0.9) + 0.5 * (1. - d.y) * (1. - d.y)) +
    (1. - up) * glm::dvec3(0.25, 0.2, 0.15);
  for (int i = 0; i < 24; ++i)
  {
    const double z = 1. - (2. * i + 1.) / 24.;
    const double turn = 2.4 * i + 0.7;
    const double r = std::sqrt(1. - z * z);
    const double sharpness = 10. * std::pow(8., i % 3);
    const glm::dvec3 color(1. + i % 2, 1., 2. - i % 2);
    light += color *
      std::exp(sharpness * (d.x * r * std::cos(turn) + d.y * z + d.z * r * std::sin(turn) - 1.));
  }
  return light;
}

struct Environment
{
  std::string Name;
  Radiance Light;
};

// The environment is an image read bilinearly, whatever its texels are. Light is clamped to 10
// times its mean: a sun, which would dominate the error, is better a separate lamp.
bool ReadEnvironment(const std::string& name, std::vector<Environment>& all)
{
  const char* folder = std::getenv("RELIEVO_DATA");
  const std::string path = std::string(folder ? folder : "build/data") + "/" + name + ".exr";
  if (!std::ifstream(path))
  {
    std::cout << name << ": " << path << " is missing, left out; run tools/unpack-data"
              << std::endl;
    return true;
  }
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values = values ? values : image->GetPointData()->GetArray("color");
  const int* size = image->GetDimensions();
  if (!values || values->GetNumberOfComponents() < 3 || size[0] != 2 * size[1])
  {
    std::cerr << "relievo: bench: " << path << " holds no equirectangular picture\n";
    return false;
  }
  const int width = size[0];
  const int height = size[1];
  std::vector<glm::dvec3> texels;
  double mean = 0.;
  double weights = 0.;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    texels.emplace_back(
      values->GetComponent(i, 0), values->GetComponent(i, 1), values->GetComponent(i, 2));
    const double across = std::sin(Pi * (static_cast<double>(i / width) + 0.5) / height);
    mean += across * (texels[i].x + texels[i].y + texels[i].z) / 3.;
    weights += across;
  }
  for (glm::dvec3& texel : texels)
  {
    texel = glm::min(texel, glm::dvec3(10. * mean / weights));
  }
  all.push_back(
    { name + ", light cut at 10 means", [texels, width, height](const glm::dvec3& d) {
       const glm::dvec2 uv = relievo::f64::relievoEquirectangularFromDirection(d);
       const double x = uv.x * width - 0.5;
       const double y = std::clamp(uv.y * height - 0.5, 0., height - 1.0001);
       const int i = static_cast<int>(std::floor(x));
       const int j = static_cast<int>(y);
       const auto at = [&](int column, int row) {
         return texels[static_cast<std::size_t>(row) * width + (column + width) % width];
       };
       return glm::mix(glm::mix(at(i, j), at(i + 1, j), x - i),
         glm::mix(at(i, j + 1), at(i + 1, j + 1), x - i), y - j);
     } });
  return true;
}

struct Result
{
  int Texels = 0;
  double Rms = 0.; // of the mean light
  std::vector<double> ByAngle;
};

Result Measure(
  const Way& way, int texels, const Radiance& light, double mean, const EnvironmentSizes& sizes)
{
  // At least as many samples per texel as the finest map has.
  const int samples =
    std::clamp(static_cast<int>(std::lround(sizes.Detail / std::sqrt(texels))), 3, 40);
  Result result;
  std::vector<double> sums(Belts, 0.);
  std::vector<double> counts(Belts, 0.);
  for (int turn = 0; turn < sizes.Turns; ++turn)
  {
    const auto turned = [&](const glm::dvec3& d) { return light(Turned(turn, sizes.Turns, d)); };
    const EnvironmentTexels map(
      way.Map, EnvironmentTexels::SizeFor(way.Map, texels), turned, samples);
    result.Texels = map.GetNumberOfTexels();
    for (int i = 0; i < sizes.Looks; ++i)
    {
      const glm::dvec3 d = Look(i, sizes.Looks);
      const glm::dvec3 off = map.Read(d) - turned(d);
      const double angle = std::acos(std::clamp(d[way.Axis], -1., 1.));
      const int belt = std::min(Belts - 1, static_cast<int>(angle / Pi * Belts));
      sums[belt] += glm::dot(off, off) / 3.;
      counts[belt] += 1.;
    }
  }
  double all = 0.;
  for (int i = 0; i < Belts; ++i)
  {
    all += sums[i];
    result.ByAngle.push_back(std::sqrt(sums[i] / counts[i]) / mean);
  }
  result.Rms = std::sqrt(all / sizes.Looks / sizes.Turns) / mean;
  return result;
}

}

//------------------------------------------------------------------------------
int relievoBench::BenchEnvironment(const std::string& outDir, const EnvironmentSizes& sizes)
{
  std::vector<Environment> environments = { { "sky and lobes", SkyAndLobes } };
  if (!MakeFolder(outDir) || (sizes.RealWorlds && !ReadEnvironment("forest", environments)))
  {
    return 1;
  }
  Table table({ "environment", "map", "texels", "RMS error / mean light", "0 to 30 degrees",
    "60 to 120 degrees", "150 to 180 degrees" });
  Table byAngle({ "environment", "map", "texels", "degrees", "RMS error / mean light" });
  const int chosen = sizes.Sides[sizes.Sides.size() - 2];
  for (const Environment& environment : environments)
  {
    double mean = 0.;
    for (int i = 0; i < sizes.Looks; ++i)
    {
      const glm::dvec3 light = environment.Light(Look(i, sizes.Looks));
      mean += (light.x + light.y + light.z) / (3. * sizes.Looks);
    }
    for (const Way& way : Ways)
    {
      for (const int side : sizes.Sides)
      {
        const Result result = Measure(way, 6 * side * side, environment.Light, mean, sizes);
        const auto within = [&result](int first, int last) {
          double sum = 0.;
          double weights = 0.;
          for (int i = first; i < last; ++i)
          {
            const double weight = std::cos(Pi * i / Belts) - std::cos(Pi * (i + 1) / Belts);
            sum += weight * result.ByAngle[i] * result.ByAngle[i];
            weights += weight;
          }
          return Number(std::sqrt(sum / weights));
        };
        table.AddRow({ environment.Name, way.Name, std::to_string(result.Texels),
          Number(result.Rms), within(0, 3), within(6, 12), within(15, 18) });
        for (int i = 0; i < Belts && side == chosen; ++i)
        {
          byAngle.AddRow({ environment.Name, way.Name, std::to_string(result.Texels),
            Number((i + 0.5) * 180. / Belts), Number(result.ByAngle[i]) });
        }
        std::cout << environment.Name << ", " << way.Name << ", " << result.Texels
                  << " texels: " << Number(result.Rms) << " of the mean light" << std::endl;
      }
    }
  }
  const bool written = table.WriteCsv(outDir + "/environment.csv") &&
    byAngle.WriteCsv(outDir + "/environment-angle.csv") && BenchEnvironmentFrames(outDir, sizes);
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchEnvironment(const std::string& outDir)
{
  return BenchEnvironment(outDir, EnvironmentSizes());
}
