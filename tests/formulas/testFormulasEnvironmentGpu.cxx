// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The formulas of environments on the GPU equal those in C++ (float); and cube maps are looked up
// as by OpenGL's own samplerCube.
#include "Check.h"
#include "CubeLookup.h"
#include "GpuCompare.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace testFormulasEnvironmentGpu
{
namespace
{
using namespace relievoTest;
namespace f64 = relievo::f64;

// Places with every face's number in turn; cosines and roughnesses are such places as well.
std::vector<CaseInput> PlaceInputs()
{
  std::vector<CaseInput> inputs = UnitInputs();
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    inputs[i].B.x = static_cast<std::uint32_t>(i % 6);
  }
  return inputs;
}

// Directions beside which no face, and no side of the seam or the rim, begins.
std::vector<CaseInput> DirectionInputs()
{
  std::vector<CaseInput> inputs;
  for (const glm::dvec3& d : Directions(50000))
  {
    const double most = std::max({ std::abs(d.x), std::abs(d.y), std::abs(d.z) });
    const int near =
      (std::abs(d.x) > most - 1e-6) + (std::abs(d.y) > most - 1e-6) + (std::abs(d.z) > most - 1e-6);
    if (near == 1 && !(d.x < 0. && std::abs(d.z) < 1e-3) && std::hypot(d.x, d.z) > 1e-3 &&
      std::hypot(d.x, d.y) > 1e-3)
    {
      inputs.push_back(Input(d.x, d.y, d.z));
    }
  }
  return inputs;
}

void TestEnvironment(GpuCases& gpu)
{
  // The driver's own atan, sin and cos: 5e-6 of a turn is 0.002 degrees.
  const Rule angle = Number(0., 5e-6);
  const Rule place = Number(1e-6, 1e-6);
  const std::vector<CaseInput> directions = DirectionInputs();
  Compare(gpu, { 40, "equirectangular, sphere map", { angle, angle, place, place } }, directions);
  Compare(gpu, { 41, "cube", { Same, place, place, place } }, directions);
  const std::vector<CaseInput> places = PlaceInputs();
  Compare(gpu, { 42, "of equirectangular", { angle, angle, angle, angle } }, places);
  Compare(gpu, { 43, "of cube", { place, place, place, place } }, places);
  Compare(gpu, { 44, "of sphere map", { place, place, place, place } }, places);
  Compare(
    gpu, { 45, "densities, GGX", { Number(0., 1e-4), place, Number(2e-5, 1e-6), place } }, places);
  Compare(
    gpu, { 46, "irradiance", { Number(0., 1e-4), Number(0., 1e-5), place, place } }, directions);
  const Rule share = Number(0., 3e-7);
  Compare(gpu, { 47, "Fresnel share", { share, share, share, share } }, UnitInputs());
}

// OpenGL's own look-up, nearest texel, against the formulas: for every texel's centre of a cube and
// for directions everywhere that are not within a hundredth of a texel of two texels.
void TestSamplerCube()
{
  for (const int size : { 1, 2, 7, 64 })
  {
    std::vector<glm::vec3> directions;
    std::vector<CubeTexel> expected;
    for (int face = 0; face < 6; ++face)
    {
      for (int j = 0; j < size; ++j)
      {
        for (int i = 0; i < size; ++i)
        {
          const glm::dvec2 st((i + 0.5) / size, (j + 0.5) / size);
          directions.push_back(f64::relievoDirectionFromCube(st, face));
          expected.push_back({ face, i, j });
        }
      }
    }
    for (const glm::dvec3& d : Directions(20000))
    {
      const int face = f64::relievoCubeFace(d);
      const glm::dvec2 place = f64::relievoCubeFromDirection(d, face) * double(size);
      const glm::dvec2 part = glm::fract(place);
      const glm::dvec2 inner = glm::abs(part - 0.5);
      if (inner.x < 0.49 && inner.y < 0.49)
      {
        directions.push_back(d);
        expected.push_back({ face, int(place.x), int(place.y) });
      }
    }
    const std::vector<CubeTexel> found = LookUpCube(size, directions);
    if (!RELIEVO_CHECK(found.size() == expected.size() && found.size() > 10000))
    {
      continue;
    }
    int mismatches = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      mismatches += found[i].Face == expected[i].Face && found[i].I == expected[i].I &&
          found[i].J == expected[i].J
        ? 0
        : 1;
    }
    RELIEVO_CHECK_AT_MOST(
      mismatches, 0, "texels that samplerCube finds elsewhere, faces of " + std::to_string(size));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasEnvironmentGpu)
{
  Session session;
  {
    GpuCases gpu;
    if (gpu.IsValid())
    {
      TestEnvironment(gpu);
    }
  }
  TestSamplerCube();
  return session.Result();
}
}
