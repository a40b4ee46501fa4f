// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuCompare.h"

#include "Check.h"
#include "Samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace relievoTest
{
using relievo::bits::FromFloat;
using relievo::bits::ToFloat;

namespace
{
// 0 when equal; above 1 when outside the rule.
double Distance(const Rule& rule, std::uint32_t gpu, std::uint32_t cpu)
{
  if (gpu == cpu)
  {
    return 0.;
  }
  if (rule.Bits == 0)
  {
    const double a = ToFloat(gpu);
    const double b = ToFloat(cpu);
    if (a == b || (std::isnan(a) && std::isnan(b)))
    {
      return 0.;
    }
    const double distance = std::abs(a - b) / (rule.Relative * std::abs(b) + rule.Absolute);
    return std::isnan(distance) ? Infinity : distance;
  }
  if (rule.Codes == 0 || gpu == 0 || cpu == 0)
  {
    return Infinity;
  }
  std::int64_t most = 0;
  for (int shift = 0; shift < 32; shift += rule.Bits)
  {
    const std::int64_t mask = (std::int64_t(1) << rule.Bits) - 1;
    most = std::max(most, std::abs(((gpu >> shift) & mask) - ((cpu >> shift) & mask)));
  }
  return static_cast<double>(most) / rule.Codes;
}
}

//------------------------------------------------------------------------------
void Compare(GpuCases& gpu, const Case& one, const std::vector<CaseInput>& inputs)
{
  const std::vector<glm::uvec4> expected = RunFloat(one.Which, inputs);
  const std::vector<glm::uvec4> got = gpu.Run(one.Which, inputs);
  if (!RELIEVO_CHECK(got.size() == expected.size()))
  {
    return;
  }
  std::size_t differing = 0;
  double worst = 0.;
  std::size_t worstInput = 0;
  int worstComponent = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    bool same = true;
    for (int c = 0; c < 4; ++c)
    {
      const double distance = Distance(one.Rules[c], got[i][c], expected[i][c]);
      same = same && got[i][c] == expected[i][c];
      if (distance > worst)
      {
        worst = distance;
        worstInput = i;
        worstComponent = c;
      }
    }
    differing += same ? 0 : 1;
  }
  std::cout << one.Which << " " << one.Name << ": " << inputs.size() << " inputs, " << differing
            << " differ in a bit, worst " << worst << " of what is allowed\n";
  const glm::uvec4 a = inputs[worstInput].A;
  const auto hex = [](std::uint32_t word) {
    char text[48];
    std::snprintf(text, sizeof(text), "%08x (%.9g)", word, ToFloat(word));
    return std::string(text);
  };
  RELIEVO_CHECK_THAT(worst <= 1.,
    std::string(one.Name) + " component " + std::to_string(worstComponent) + ": GPU " +
      hex(got[worstInput][worstComponent]) + ", C++ " + hex(expected[worstInput][worstComponent]) +
      " from " + hex(a.x) + " " + hex(a.y) + " " + hex(a.z));
}

//------------------------------------------------------------------------------
CaseInput Input(double x, double y, double z, const glm::uvec4& b)
{
  return { glm::uvec4(FromFloat(float(x)), FromFloat(float(y)), FromFloat(float(z)), 0u), b };
}

//------------------------------------------------------------------------------
std::vector<CaseInput> UnitInputs()
{
  std::vector<CaseInput> inputs;
  inputs.reserve(50005);
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for (int i = 0; i < 50000; ++i)
  {
    inputs.push_back(Input(uniform(random), uniform(random), uniform(random)));
  }
  for (double x : { 0., 1., 0.0031308, 0.04045, 0.5 })
  {
    inputs.push_back(Input(x, x, x));
  }
  return inputs;
}
}
