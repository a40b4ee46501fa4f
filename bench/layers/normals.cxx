// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 1: angular error of each normal format, against its bits and its time.
//
// Directions are computed in double, rounded to float, encoded and decoded by the formulas in float
// as in shaders, and compared with the direction in double.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "NormalPeers.h"
#include "Statistics.h"
#include "Table.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
namespace f32 = relievo::f32;

constexpr double Pi = 3.14159265358979323846;

// A number in [0, 1) from a counter: equal on every machine, unlike std's distributions.
double Unit(std::uint64_t counter)
{
  std::uint64_t z = (counter + 1u) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

glm::dvec3 UniformDirection(std::size_t i)
{
  const double z = 2. * Unit(2 * i) - 1.;
  const double azimuth = 2. * Pi * Unit(2 * i + 1);
  const double radius = std::sqrt((1. - z) * (1. + z));
  return { radius * std::cos(azimuth), radius * std::sin(azimuth), z };
}

// Corners of encodings: the axes; the planes between octants, exactly and 1e-7 to either side; and
// the surroundings of the axes, from 1e-1 to 1e-7 radians.
glm::dvec3 SpecialDirection(std::size_t i)
{
  const int axis = static_cast<int>(i % 3);
  const double side = (i / 3) % 2 ? 1. : -1.;
  const double azimuth = 2. * Pi * Unit(3 * i);
  glm::dvec3 n(0.);
  if (i < 6)
  {
    n[axis] = side;
  }
  else if ((i / 6) % 2)
  {
    const double offsets[] = { -1e-7, 0., 1e-7 };
    n[axis] = offsets[(i / 12) % 3];
    n[(axis + 1) % 3] = std::cos(azimuth);
    n[(axis + 2) % 3] = std::sin(azimuth);
  }
  else
  {
    const double away = std::pow(10., -1. - 6. * Unit(3 * i + 1));
    n[axis] = side * std::cos(away);
    n[(axis + 1) % 3] = std::sin(away) * std::cos(azimuth);
    n[(axis + 2) % 3] = std::sin(away) * std::sin(azimuth);
  }
  return glm::normalize(n);
}

double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * (180. / Pi);
}

template <int Bits>
struct Oct
{
  static std::uint32_t Encode(const glm::vec3& n) { return f32::relievoOctPack(n, Bits); }
  static glm::vec3 Decode(std::uint32_t word) { return f32::relievoOctUnpack(word, Bits); }
};

template <int Bits>
struct OctPrecise
{
  static std::uint32_t Encode(const glm::vec3& n) { return f32::relievoOctPackPrecise(n, Bits); }
  static glm::vec3 Decode(std::uint32_t word) { return f32::relievoOctUnpack(word, Bits); }
};

template <int Bits>
struct Biased
{
  static std::uint32_t Encode(const glm::vec3& n) { return f32::relievoPackNormalBiased(n, Bits); }
  static glm::vec3 Decode(std::uint32_t word) { return f32::relievoUnpackNormalBiased(word, Bits); }
};

struct Half
{
  static glm::uvec2 Encode(const glm::vec3& n) { return f32::relievoPackNormalHalf(n); }
  static glm::vec3 Decode(const glm::uvec2& words) { return f32::relievoUnpackNormalHalf(words); }
};

struct Float
{
  static glm::uvec3 Encode(const glm::vec3& n) { return f32::relievoPackNormalFloat(n); }
  static glm::vec3 Decode(const glm::uvec3& words) { return f32::relievoUnpackNormalFloat(words); }
};

struct Result
{
  std::string Family;
  std::string Name;
  int Bits;
  Statistics Uniform;
  Statistics Special;
  double Max;
  double EncodeNs;
  double DecodeNs;
};

template <typename Format>
Statistics Errors(std::size_t count, glm::dvec3 (*direction)(std::size_t))
{
  std::vector<float> errors(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 n = direction(i);
    const glm::dvec3 decoded(Format::Decode(Format::Encode(glm::vec3(n))));
    errors[i] = static_cast<float>(Degrees(n, decoded));
  }
  return Summarize(errors);
}

// Nanoseconds per call: the fastest of many rounds, since other work only adds time.
template <typename Work>
double Nanoseconds(std::size_t count, Work work)
{
  double best = 1e9;
  for (int round = 0; round < 40; ++round)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(count));
  }
  return best;
}

template <typename Format>
Result Measure(const NormalSizes& sizes, const char* family, const std::string& name, int bits)
{
  constexpr std::size_t Count = 8192; // fits into the second-level cache
  std::vector<glm::vec3> normals(Count);
  std::vector<decltype(Format::Encode(glm::vec3()))> words(Count);
  std::vector<glm::vec3> decoded(Count);
  for (std::size_t i = 0; i < Count; ++i)
  {
    normals[i] = glm::vec3(UniformDirection(i));
  }
  Result result;
  result.Family = family;
  result.Name = name;
  result.Bits = bits;
  result.EncodeNs = Nanoseconds(Count,
    [&]() { std::transform(normals.begin(), normals.end(), words.begin(), &Format::Encode); });
  result.DecodeNs = Nanoseconds(
    Count, [&]() { std::transform(words.begin(), words.end(), decoded.begin(), &Format::Decode); });
  result.Uniform = Errors<Format>(sizes.Uniform, UniformDirection);
  result.Special = Errors<Format>(sizes.Special, SpecialDirection);
  result.Max = std::max(result.Uniform.Max, result.Special.Max);
  std::cout << name << ", " << bits << " bits: mean " << Number(result.Uniform.Mean) << ", p99 "
            << Number(result.Uniform.P99) << ", max " << Number(result.Uniform.Max)
            << ", max at axes and seams " << Number(result.Special.Max) << " degrees; encode "
            << Number(result.EncodeNs, 3) << " ns, decode " << Number(result.DecodeNs, 3) << " ns"
            << std::endl;
  return result;
}

template <template <int> class Format>
void MeasurePairs(const NormalSizes& sizes, const char* family, std::vector<Result>& results)
{
  const std::string name = family;
  results.push_back(Measure<Format<8>>(sizes, family, name + " 2x8", 16));
  results.push_back(Measure<Format<16>>(sizes, family, name + " 2x16", 32));
}

template <template <int> class Format>
void MeasureOct(const NormalSizes& sizes, const char* family, std::vector<Result>& results)
{
  const std::string name = family;
  results.push_back(Measure<Format<8>>(sizes, family, name + " 2x8", 16));
  results.push_back(Measure<Format<10>>(sizes, family, name + " 2x10", 20));
  results.push_back(Measure<Format<12>>(sizes, family, name + " 2x12", 24));
  results.push_back(Measure<Format<16>>(sizes, family, name + " 2x16", 32));
}

}

//------------------------------------------------------------------------------
int relievoBench::BenchNormals(const std::string& outDir, const NormalSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  std::vector<Result> results;
  MeasureOct<Oct>(sizes, "octahedral", results);
  MeasureOct<OctPrecise>(sizes, "octahedral precise", results);
  results.push_back(Measure<Biased<8>>(sizes, "0.5n+0.5", "0.5n+0.5 RGB8", 24));
  results.push_back(Measure<Biased<10>>(sizes, "0.5n+0.5", "0.5n+0.5 RGB10A2", 32));
  results.push_back(Measure<Half>(sizes, "half", "half xyz", 48));
  results.push_back(Measure<Float>(sizes, "float", "float xyz", 96));
  MeasurePairs<Spherical>(sizes, "spherical angles", results);
  MeasurePairs<Azimuthal>(sizes, "azimuthal", results);

  Table table({ "format", "bits", "mean degrees", "p99", "max", "max at axes and seams",
    "encode ns", "decode ns" });
  for (const Result& result : results)
  {
    table.AddRow({ result.Name, std::to_string(result.Bits), Number(result.Uniform.Mean),
      Number(result.Uniform.P99), Number(result.Uniform.Max), Number(result.Special.Max),
      Number(result.EncodeNs, 3), Number(result.DecodeNs, 3) });
  }
  return table.WriteCsv(outDir + "/normals.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchNormals(const std::string& outDir)
{
  return BenchNormals(outDir, NormalSizes());
}
