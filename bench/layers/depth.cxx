// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 2: error of each depth format, against its bytes and far / near.
//
// Depths are float, as interpolated by a GPU; they are encoded and decoded by the formulas in
// float, as in shaders; the truth is the depth in double before it was rounded to float.
#include "RelievoBench.h"

#include "Statistics.h"
#include "Table.h"
#include "vtkRelievoFormulas.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
namespace f32 = relievo::f32;

constexpr double Near = 1.;
const double Ratios[] = { 1e2, 1e3, 1e4, 1e5, 1e6 };
constexpr int Samples = 1000000;
constexpr int OrderedDepths = 10000;

float ThroughAlpha8(float depth, float zNear, float zFar)
{
  const glm::vec3 n(0.f, 0.f, 1.f);
  const std::uint32_t word = f32::relievoPackNormalDepth8(n, depth, zNear, zFar);
  return f32::relievoUnpackNormalDepth8(word, zNear, zFar).w;
}

float ThroughHalf(float depth, float, float)
{
  return f32::relievoUnpackDepth16F(f32::relievoPackDepth16F(depth, 1.f), 1.f);
}

float ThroughScaledHalf(float depth, float, float zFar)
{
  const float scale = f32::relievoDepth16FScale(zFar);
  return f32::relievoUnpackDepth16F(f32::relievoPackDepth16F(depth, scale), scale);
}

float ThroughWindowZ24(float depth, float zNear, float zFar)
{
  const float windowZ = f32::relievoPerspectiveWindowZ(depth, zNear, zFar);
  const float stored = f32::relievoUnpackWindowZ24(f32::relievoPackWindowZ24(windowZ));
  return f32::relievoPerspectiveDepth(stored, zNear, zFar);
}

float ThroughWindowZ32(float depth, float zNear, float zFar)
{
  const float windowZ = f32::relievoPerspectiveWindowZ(depth, zNear, zFar);
  return f32::relievoPerspectiveDepth(windowZ, zNear, zFar);
}

float ThroughReversed32(float depth, float zNear, float zFar)
{
  const float reversedZ = f32::relievoPerspectiveReversedZ(depth, zNear, zFar);
  return f32::relievoPerspectiveDepthFromReversed(reversedZ, zNear, zFar);
}

float ThroughLinear32(float depth, float, float)
{
  return f32::relievoUnpackDepth32F(f32::relievoPackDepth32F(depth));
}

struct Method
{
  const char* Name;
  int Bytes;
  float (*Through)(float depth, float zNear, float zFar);
};

const Method Methods[] = {
  { "RGBA8 alpha, linear", 1, ThroughAlpha8 },
  { "R16F, world units", 2, ThroughHalf },
  { "R16F, scaled by 2^k", 2, ThroughScaledHalf },
  { "window z, 24 bits", 3, ThroughWindowZ24 },
  { "window z, 32F", 4, ThroughWindowZ32 },
  { "reversed z, 32F", 4, ThroughReversed32 },
  { "R32F, linear", 4, ThroughLinear32 },
};

Statistics RelativeErrors(const Method& method, double ratio)
{
  std::vector<float> errors(Samples);
  for (int i = 0; i < Samples; ++i)
  {
    const double depth = Near * std::pow(ratio, (i + 0.5) / Samples);
    const float back = method.Through(static_cast<float>(depth), float(Near), float(Near * ratio));
    errors[i] = static_cast<float>(std::abs(back - depth) / depth);
  }
  return Summarize(errors);
}

// Neighbours among evenly spaced depths from near to far: the shares that become equal, or are read
// back in the wrong order.
struct Order
{
  double Equal = 0.;
  double Swapped = 0.;
};

Order OrderOfNeighbours(const Method& method, double ratio)
{
  Order order;
  float last = 0.f;
  for (int i = 0; i < OrderedDepths; ++i)
  {
    const double depth = Near + (ratio - 1.) * Near * i / (OrderedDepths - 1.);
    const float back = method.Through(static_cast<float>(depth), float(Near), float(Near * ratio));
    if (i > 0)
    {
      order.Equal += back == last ? 1. : 0.;
      order.Swapped += back < last ? 1. : 0.;
    }
    last = back;
  }
  order.Equal /= OrderedDepths - 1.;
  order.Swapped /= OrderedDepths - 1.;
  return order;
}

std::string PowerOfTen(double value)
{
  return "1e" + std::to_string(static_cast<int>(std::lround(std::log10(value))));
}

}

//------------------------------------------------------------------------------
int RelievoBenchDepth(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "format", "bytes", "far/near", "relative error median", "p99", "max",
    "neighbours equal", "neighbours swapped" });
  for (const Method& method : Methods)
  {
    for (double ratio : Ratios)
    {
      const Statistics errors = RelativeErrors(method, ratio);
      const Order order = OrderOfNeighbours(method, ratio);
      table.AddRow(
        { method.Name, std::to_string(method.Bytes), PowerOfTen(ratio), Number(errors.Median),
          Number(errors.P99), Number(errors.Max), Number(order.Equal), Number(order.Swapped) });
      std::cout << method.Name << ", far / near " << PowerOfTen(ratio) << ": median "
                << Number(errors.Median) << ", p99 " << Number(errors.P99) << ", max "
                << Number(errors.Max) << "; equal " << Number(100. * order.Equal) << " %, swapped "
                << Number(100. * order.Swapped) << " %" << std::endl;
    }
  }
  return table.WriteCsv(outDir + "/depth.csv") ? 0 : 1;
}
