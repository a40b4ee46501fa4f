// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every formula gives equal results on the GPU and in C++ (float): the same lines on the same
// words.
//
// Words of codes may differ by one code where the GPU divides or takes a root with another last
// bit; words for "nothing here" may not. Numbers may differ by the tolerance that stands with the
// case; the colour curves' pow() is the driver's own and gets the widest.
#include "Check.h"
#include "GpuCompare.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace testFormulasGpu
{
namespace
{
using namespace relievoTest;
using relievo::bits::FromFloat;
using relievo::bits::ToFloat;

std::vector<CaseInput> NormalInputs()
{
  std::vector<CaseInput> inputs;
  for (const glm::dvec3& n : relievoTest::Directions(50000))
  {
    inputs.push_back(Input(n.x, n.y, n.z));
  }
  return inputs;
}

std::vector<CaseInput> NoDirectionInputs()
{
  using relievoTest::Infinity;
  using relievoTest::NaN;
  std::vector<CaseInput> inputs;
  for (double bad : { NaN, Infinity, -Infinity })
  {
    inputs.push_back(Input(bad, 0., 0.));
    inputs.push_back(Input(0., bad, 1.));
    inputs.push_back(Input(1., -1., bad));
    inputs.push_back(Input(bad, bad, bad));
  }
  inputs.push_back(Input(0., 0., 0.));
  inputs.push_back(Input(-0., -0., -0.));
  return inputs;
}

std::vector<CaseInput> WordInputs()
{
  std::vector<CaseInput> inputs = { { glm::uvec4(0u), glm::uvec4(0u) },
    { glm::uvec4(0xffffffffu), glm::uvec4(0xffffffffu) } };
  std::mt19937 random(7);
  for (int i = 0; i < 50000; ++i)
  {
    const auto word = [&random]() { return static_cast<std::uint32_t>(random()); };
    inputs.push_back({ glm::uvec4(word(), word(), word(), word()), glm::uvec4(0u) });
  }
  return inputs;
}

// Words of codes that a pack can have made: bits above `bits` clear, no code 0.
std::vector<CaseInput> CodeInputs(int codeBits)
{
  std::vector<CaseInput> inputs = WordInputs();
  const std::uint32_t ones = codeBits == 8 ? 0x0101u : 0x00010001u;
  for (CaseInput& input : inputs)
  {
    input.A.x = input.A.x == 0u ? 0u : (input.A.x & (codeBits == 8 ? 0xffffu : ~0u)) | ones;
  }
  return inputs;
}

std::vector<CaseInput> FloatWordInputs()
{
  std::vector<CaseInput> inputs = NormalInputs();
  for (CaseInput& input : inputs)
  {
    const glm::vec3 n(ToFloat(input.A.x), ToFloat(input.A.y), ToFloat(input.A.z));
    const glm::uvec2 halves = relievo::f32::relievoPackNormalHalf(n);
    input.A = glm::uvec4(halves.x, halves.y, input.A.z, 0u);
  }
  return inputs;
}

std::vector<CaseInput> DepthInputs()
{
  std::vector<CaseInput> inputs;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (double ratio : { 10., 1e2, 1e3, 1e4, 1e5, 1e6, 1e7 })
  {
    for (double depth : relievoTest::Depths(4000, 0.25, 0.25 * ratio))
    {
      const glm::dvec3 n = glm::normalize(glm::dvec3(normal(random), normal(random), 1.));
      const glm::uvec4 words(
        FromFloat(float(n.x)), FromFloat(float(n.y)), FromFloat(float(n.z)), 0u);
      inputs.push_back(Input(depth, 0.25, 0.25 * ratio, words));
    }
    inputs.push_back(Input(relievoTest::Infinity, 0.25, 0.25 * ratio));
  }
  return inputs;
}

std::vector<CaseInput> ZInputs()
{
  std::vector<CaseInput> inputs;
  for (double ratio : { 10., 1e3, 1e5, 1e7 })
  {
    for (int i = 0; i <= 4000; ++i)
    {
      inputs.push_back(Input(i / 4000., 0.25, 0.25 * ratio));
    }
  }
  return inputs;
}

std::vector<CaseInput> PixelInputs()
{
  std::vector<CaseInput> inputs;
  inputs.reserve(50005);
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0., 1.);
  const glm::uvec4 size(FromFloat(1920.f), FromFloat(1080.f), FromFloat(1.f), 0u);
  for (int i = 0; i < 50000; ++i)
  {
    inputs.push_back(Input(std::floor(1920. * uniform(random)), std::floor(1080. * uniform(random)),
      1. + uniform(random), size));
  }
  return inputs;
}

std::vector<CaseInput> PositionInputs()
{
  std::vector<CaseInput> inputs;
  inputs.reserve(50005);
  std::mt19937 random(19);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const glm::uvec4 size(FromFloat(1920.f), FromFloat(1080.f), FromFloat(1.f), 0u);
  for (int i = 0; i < 50000; ++i)
  {
    inputs.push_back(Input(uniform(random), uniform(random), -1.5 - 0.5 * uniform(random), size));
  }
  return inputs;
}

std::vector<CaseInput> ShiftToB(std::vector<CaseInput> inputs)
{
  for (CaseInput& input : inputs)
  {
    input.B = input.A;
    input.A = Input(1., 0.5, 200.).A;
  }
  return inputs;
}

void TestNormals(relievoTest::GpuCases& gpu)
{
  const Rule unit = Number(0., 3e-7);
  const std::vector<CaseInput> normals = NormalInputs();
  Compare(gpu,
    { 0, "oct8, oct8 precise, oct16, oct16 precise", { Codes(8), Codes(8), Codes(16), Codes(16) } },
    normals);
  Compare(
    gpu, { 1, "unorm8, unorm10, half", { Codes(8), Codes(10), Codes(16), Codes(16) } }, normals);
  Compare(gpu, { 2, "float", { Same, Same, Same, Same } }, normals);
  const std::vector<CaseInput> none = NoDirectionInputs();
  for (int which : { 0, 1, 2 })
  {
    Compare(gpu, { which, "no direction", { Same, Same, Same, Same } }, none);
    for (const glm::uvec4& words : relievoTest::RunFloat(which, none))
    {
      RELIEVO_CHECK(words == glm::uvec4(0u));
    }
  }
  Compare(gpu, { 3, "unpack oct8", { unit, unit, unit, unit } }, CodeInputs(8));
  Compare(gpu, { 4, "unpack oct16", { unit, unit, unit, unit } }, CodeInputs(16));
  Compare(gpu, { 5, "unpack unorm8", { unit, unit, unit, unit } }, WordInputs());
  Compare(gpu, { 6, "unpack unorm10", { unit, unit, unit, unit } }, WordInputs());
  Compare(gpu, { 7, "unpack half", { unit, unit, unit, unit } }, FloatWordInputs());
  Compare(gpu, { 8, "unpack float", { Same, Same, Same, Same } }, normals);
}

void TestDepth(relievoTest::GpuCases& gpu)
{
  const std::vector<CaseInput> depths = DepthInputs();
  const Rule ulp = Number(3e-7, 0.);
  const Rule unit = Number(0., 1.2e-7);
  Compare(gpu, { 10, "window z, reversed z", { unit, Number(3e-7, 1e-14), unit, unit } }, depths);
  Compare(gpu,
    { 11, "depth of z", { Number(6e-7, 0.), Number(6e-7, 0.), Number(3e-7, 0.), Number(0., 3.) } },
    ZInputs());
  Compare(gpu, { 12, "normalised depth", { unit, Number(3e-7, 1e-7), Same, Same } }, depths);
  Compare(gpu, { 13, "depth words", { Codes(24), Codes(16), Codes(16), Same } }, UnitInputs());
  Compare(gpu, { 13, "depth words of depths", { Same, Codes(16), Codes(16), Same } }, depths);
  Compare(gpu, { 14, "unpack depth", { ulp, ulp, ulp, Same } }, WordInputs());
  Compare(gpu, { 15, "normal + depth", { Codes(8), Codes(16), Codes(16), Same } }, depths);
  const Rule near = Number(3e-7, 3e-7);
  Compare(
    gpu, { 16, "unpack RGBA8", { near, near, near, Number(3e-7, 0.) } }, ShiftToB(WordInputs()));
  Compare(gpu, { 17, "unpack RGBA16F", { near, near, near, Same } }, ShiftToB(FloatWordInputs()));
  Compare(gpu, { 18, "unpack RGBA32F", { Same, Same, Same, Same } }, ShiftToB(NormalInputs()));
}

void TestSpace(relievoTest::GpuCases& gpu)
{
  const std::vector<CaseInput> pixels = PixelInputs();
  // Components pass through zero; depths and directions are of size 1.
  const Rule position = Number(5e-7, 1e-6);
  const char* names[] = { "eye, perspective", "eye, parallel", "eye, any perspective",
    "eye, any parallel", "direction, range" };
  for (int i = 0; i < 5; ++i)
  {
    Compare(gpu, { 20 + i, names[i], { position, position, position, position } }, pixels);
  }
  const std::vector<CaseInput> positions = PositionInputs();
  const Rule window = Number(0., 1e-3);
  Compare(gpu, { 25, "world", { position, position, position, position } }, positions);
  Compare(gpu, { 26, "clip to window", { window, window, position, position } }, positions);
  Compare(gpu, { 27, "window to NDC", { position, position, position, position } }, pixels);
}

std::vector<CaseInput> LightInputs()
{
  using relievoTest::Infinity;
  using relievoTest::NaN;
  std::vector<CaseInput> inputs;
  const double special[] = { 0., -0., 1e-7, 0.18, 1., 4., 65504., 1e9, -0.1, -1e9, Infinity,
    -Infinity, NaN };
  for (double x : special)
  {
    for (double y : special)
    {
      for (double z : special)
      {
        inputs.push_back(Input(x, y, z));
      }
    }
  }
  std::mt19937 random(23);
  std::uniform_real_distribution<double> stops(-14., 16.);
  for (int i = 0; i < 50000; ++i)
  {
    inputs.push_back(
      Input(std::exp2(stops(random)), std::exp2(stops(random)), std::exp2(stops(random))));
  }
  return inputs;
}

void TestColor(relievoTest::GpuCases& gpu)
{
  const Rule curve = Number(0., 2e-6);
  Compare(gpu, { 30, "to sRGB", { curve, curve, curve, curve } }, UnitInputs());
  Compare(gpu, { 31, "from sRGB", { curve, curve, curve, curve } }, UnitInputs());
  Compare(gpu, { 32, "colour map", { curve, curve, curve, curve } }, UnitInputs());
  const Rule color = Number(0., 1e-6);
  Compare(gpu, { 33, "colour of an id", { color, color, color, color } }, WordInputs());
  Compare(gpu, { 34, "hash", { Same, Same, Same, Same } }, WordInputs());
  const Rule roots = Number(4e-6, 2e-6);
  for (const std::vector<CaseInput>& inputs : { UnitInputs(), LightInputs() })
  {
    Compare(gpu, { 35, "to approximate sRGB", { roots, roots, roots, roots } }, inputs);
    Compare(gpu, { 36, "from approximate sRGB", { roots, roots, roots, roots } }, inputs);
  }
}

void TestTone(relievoTest::GpuCases& gpu)
{
  const std::vector<CaseInput> light = LightInputs();
  const Rule shown = Number(0., 1.7e-6); // see testFormulasTone
  const char* names[] = { "clamp", "simple", "Reinhard", "Reinhard by component" };
  for (int i = 0; i < 4; ++i)
  {
    Compare(gpu, { 50 + i, names[i], { shown, shown, shown, shown } }, light);
  }
  Compare(gpu, { 58, "neutral", { shown, shown, shown, shown } }, light);
  const Rule ulps = Number(6e-7, 0.);
  const Rule stops = Number(1e-6, 4e-6);
  Compare(gpu, { 54, "luminance", { ulps, stops, Number(1e-5, 0.), Same } }, light);
  Compare(gpu, { 55, "Reinhard's ratio", { ulps, ulps, ulps, ulps } }, light);
  std::vector<CaseInput> pixels;
  for (std::uint32_t i = 0; i < 64; ++i)
  {
    pixels.push_back({ glm::uvec4(i % 8, i / 8, 1000 + i, 0u), glm::uvec4(0u) });
  }
  Compare(gpu, { 56, "thresholds", { Same, Same, Number(2e-7, 0.), Same } }, pixels);
  // Where the sum is close to a whole number, another rounding gives the neighbouring step.
  const Rule step = Number(0., 1. / 255. + 1e-6);
  Compare(gpu, { 57, "dithering", { step, step, Same, Same } }, UnitInputs());
}

// Two triples, of numbers of either sign and of sizes from 1e-6 to 1.
std::vector<CaseInput> PairInputs()
{
  std::vector<CaseInput> inputs;
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const auto number = [&]() { return uniform(random) * std::pow(10., 3. * uniform(random) - 3.); };
  for (int i = 0; i < 50000; ++i)
  {
    const double first[3] = { number(), number(), number() };
    const glm::uvec4 second(FromFloat(static_cast<float>(number())),
      FromFloat(static_cast<float>(number())), FromFloat(static_cast<float>(number())), 0u);
    inputs.push_back(Input(first[0], first[1], first[2], second));
  }
  return inputs;
}

void TestFog(relievoTest::GpuCases& gpu)
{
  const std::vector<CaseInput> inputs = PairInputs();
  Compare(gpu, { 60, "sum, product", { Same, Same, Same, Same } }, inputs);
  Compare(gpu, { 61, "of pairs", { Same, Same, Same, Same } }, inputs);
  const Rule chord = Number(3e-6, 1e-6);
  Compare(gpu, { 62, "discriminant, chord", { Same, chord, chord, chord } }, inputs);
}
}

void TestNoise(relievoTest::GpuCases& gpu)
{
  std::vector<CaseInput> inputs = WordInputs();
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const glm::uvec4 next = inputs[(i + 1) % inputs.size()].A;
    inputs[i].B = glm::uvec4(next.x, next.y, next.z, 0u);
  }
  const Rule noise = Number(0., 5e-6);
  Compare(gpu, { 70, "noise", { Same, Same, noise, noise } }, inputs);
}

void TestSkin(relievoTest::GpuCases& gpu)
{
  std::vector<CaseInput> inputs;
  const std::vector<glm::dvec3> directions = relievoTest::Directions(20000);
  for (std::size_t i = 0; i + 1 < directions.size(); ++i)
  {
    const glm::dvec3& w = directions[(7 * i + 3) % directions.size()];
    const glm::uvec4 second(FromFloat(static_cast<float>(w.x)), FromFloat(static_cast<float>(w.y)),
      FromFloat(static_cast<float>(w.z)), 0u);
    inputs.push_back(Input(directions[i].x, directions[i].y, directions[i].z, second));
  }
  const Rule unit = Number(0., 2e-6);
  const char* names[] = { "nlerp", "slerp", "rotation", "quaternion of a matrix",
    "move of a dual quaternion", "normal matrix" };
  for (int i = 0; i < 6; ++i)
  {
    Compare(gpu, { 80 + i, names[i], { unit, unit, unit, unit } }, inputs);
  }
}

// The indices of nodes and triangles, up to trees of the largest size.
void TestTree(relievoTest::GpuCases& gpu)
{
  constexpr std::uint32_t Most = 1u << 24; // leaves
  std::vector<CaseInput> inputs;
  for (std::uint32_t i = 1; i <= Most; i = std::max(i + 1, i + i / 997))
  {
    inputs.push_back({ glm::uvec4(i, i - 1, 0u, 0u), glm::uvec4(0u) });
    inputs.push_back({ glm::uvec4(Most + 1 - i, Most - i, 0u, 0u), glm::uvec4(0u) });
  }
  for (const auto& run : { RunFloat(90, inputs), gpu.Run(90, inputs) })
  {
    long long mismatches = run.size() == inputs.size() ? 0 : 1;
    for (std::size_t i = 0; i < run.size(); ++i)
    {
      const glm::uvec4& a = inputs[i].A;
      mismatches += run[i] == glm::uvec4(2u * a.x - 1u, a.y, 4u * a.y, 0u) ? 0 : 1;
    }
    RELIEVO_CHECK_AT_MOST(mismatches, 0, "indices into a tree");
  }
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasGpu)
{
  relievoTest::Session session;
  {
    relievoTest::GpuCases gpu;
    if (gpu.IsValid())
    {
      TestNormals(gpu);
      TestDepth(gpu);
      TestSpace(gpu);
      TestColor(gpu);
      TestTone(gpu);
      TestFog(gpu);
      TestNoise(gpu);
      TestSkin(gpu);
      TestTree(gpu);
    }
  }
  return session.Result();
}
}
